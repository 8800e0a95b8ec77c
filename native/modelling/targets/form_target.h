// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "analysis/derivatives/form_numbers.h"

namespace hull::modelling {

// A number of the hull's form that is to lie within bounds: equal ones ask for one value.
struct FormTarget {
  // What is asked for: a number of Hydrostatics, or the area of the station at x = `station`.
  analysis::FormNumber number = analysis::FormNumber::kDisplacedVolume;
  bool is_section = false;
  double station = 0.0;
  // … or the wave resistance at a speed in m/s, kN, by Michell's integral …
  std::optional<double> wave_speed;
  // … or how far the surface lies along a direction at a place, before dimensions are scaled: a sum
  // of control points, of which many may be bounded.
  struct Coordinate {
    int cell = 0;
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitY();
  };
  std::optional<Coordinate> coordinate;

  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  // Where not all targets can be met those of more weight are rather met.
  double weight = 1.0;
};

// Limits of a factor by which a main dimension is scaled: 1 and 1 for one that stays.
struct ScaleBounds {
  double low = 1.0, high = 1.0;
  bool is_free() const { return low < high; }
};

}  // namespace hull::modelling

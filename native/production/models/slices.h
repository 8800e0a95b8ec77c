// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "production/models/closed_model.h"

namespace hull::production {

// The section of a model at a height z. Contours are closed, the first point is not repeated; they
// have the model on their left: counter-clockwise around it, clockwise around what is hollow.
struct ModelSlice {
  double height;
  std::vector<std::vector<Eigen::Vector2d>> contours;

  double area() const;
};

// At all `heights`, which rise. Points at a height count as above it, so that contours are always
// closed. REQUIRES: the model is closed. Throws std::invalid_argument for heights that do not rise.
std::vector<ModelSlice> slices(const ClosedModel& model, const std::vector<double>& heights,
                               const surface::Progress& progress = {});

inline constexpr double kMostLayers = 100000;

// Layers of a model from its lowest point up, of one thickness but for the last, which ends at the
// highest point: with the sections at their middles, whose areas times the layers' thickness sum to
// the volume but for the square of the thickness.
struct ModelLayers {
  double thickness, bottom;
  std::vector<double> tops;        // heights of the layers' upper surfaces
  std::vector<ModelSlice> slices;  // at the middles

  double volume() const;  // by that sum
};

// Throws std::invalid_argument unless the thickness is positive and makes at most kMostLayers.
ModelLayers layers(const ClosedModel& model, double thickness,
                   const surface::Progress& progress = {});

}  // namespace hull::production

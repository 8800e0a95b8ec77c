// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/appendages/section_name.h"

namespace hull::analysis {

// A NACA section of unit chord, leading edge at (0, 0), trailing edge at (1, 0): its thickness laid
// out perpendicular to its mean line.
class SectionForm {
 public:
  // Throws std::invalid_argument for what is no name as of section_named.
  explicit SectionForm(const std::string& name);

  const std::string& name() const { return name_; }
  // Largest thickness of the family, of the chord.
  double thickness() const { return form_.largest; }
  bool is_symmetric() const { return form_.mean_line.is_straight(); }
  // Half thickness at x in [0, 1] of the mean line, of the chord.
  double half_thickness(double x) const;
  double mean_line(double x) const { return form_.mean_line.height(x); }
  double mean_slope(double x) const { return form_.mean_line.slopes(x, true)[0]; }

  // A point of the outline at x = s² of the mean line, and its derivative by s: of the upper side
  // (1) or the lower one (-1), thickness times a factor. At the place where two mean lines meet,
  // the derivative is that of the part behind or before it.
  struct Point {
    Eigen::Vector2d place, slope;
  };
  Point outline(double s, int side, double factor, bool behind) const;
  // s from 0 to 1, between which cubics follow the outline within 1e-6 of the chord.
  const std::vector<double>& knots() const { return knots_; }

 private:
  std::vector<double> even_knots() const;
  void add_knots(double from, double to, int depth);
  double largest_error(double from, double to, int side) const;

  std::string name_;
  NamedSection form_;
  std::vector<double> knots_;
};

// The cubic between two points of an outline with its tangents there, by Bézier points.
std::array<Eigen::Vector2d, 4> outline_part(const SectionForm& form, double from, double to,
                                            int side, double factor);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modelling/transformation/working_hull.h"

namespace hull::modelling {

// A hull's sectional area curve as a smooth function of x, divided by its largest area: the cubic
// spline of kSpans equal spans over the immersed length with the least sum of squares from exact
// section areas. (Sections are shifted by it: jumps of the areas themselves, as at a skeg's end,
// would tear the surface.) Beyond the ends its slope fades to zero within a tenth of the length.
class AreaCurve {
 public:
  static constexpr int kSpans = 16;
  // Of the immersed length: the ends are cut so far inside, where a transom still has its area.
  static constexpr double kInside = 1e-6;

  explicit AreaCurve(const WorkingHull& hull);

  double at(double x) const;                               // 0 to 1 about
  double largest() const { return largest_; }              // m²: of the sections looked at
  double largest_position() const { return largest_at_; }  // its x, m

 private:
  double spline(double x) const;

  double aft_, forward_;  // m: of the immersed shell
  double slope_aft_, slope_forward_;
  double largest_, largest_at_;
  Eigen::VectorXd coefficients_;
};

// Values at equal distances, both ends among them.
std::vector<double> spread(double from, double to, int count);

// A range along the hull, m.
struct HullRange {
  double aft, forward;
};

// The parallel middle body: around the largest section all that have its area within kSameArea of
// it. Shorter than a thousandth of the immersed length: none, and aft = forward.
inline constexpr double kSameArea = 1e-8;
HullRange parallel_body(const WorkingHull& hull);

}  // namespace hull::modelling

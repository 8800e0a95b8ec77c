// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/plane_cut.h"

#include <algorithm>
#include <cmath>

namespace hull::analysis {
namespace {

// Slopes along v that vary by more than this factor make the crossing a badly behaved function of
// u, which quadrature and sampling would have to resolve; two smaller squares do it better.
constexpr double kSteadySlope = 0.1;

// How steadily the height rises or falls in v: 0 if not monotonic, 1 if linear.
double steadiness(const std::array<double, 2>& bounds) {
  if (bounds[0] > 0.0) return bounds[0] / bounds[1];
  if (bounds[1] < 0.0) return bounds[1] / bounds[0];
  return 0.0;
}

}  // namespace

namespace plane_cut_internal {

Shape shape_of(const BezierBicubic& height, bool deepest) {
  // Zero counts as above, so that a surface lying in the plane has no crossing.
  if (height.lowest() >= 0.0) return Shape::kAbove;
  if (height.highest() < 0.0) return Shape::kBelow;
  const double along_v = steadiness(height.slope_bounds_v());
  const double along_u = steadiness(height.slope_bounds_u());
  if (std::max(along_u, along_v) < kSteadySlope && !deepest) return Shape::kTangled;
  return along_u > along_v ? Shape::kSimpleSwapped : Shape::kSimple;
}

}  // namespace plane_cut_internal

BezierBicubic heights(const surface::BicubicPoints& points, const Plane& plane, double tolerance) {
  std::array<double, 16> values;
  for (int i = 0; i < 16; ++i) {
    const double height = plane.height(points[i]);
    values[i] = std::abs(height) < tolerance ? 0.0 : height;
  }
  return BezierBicubic::from_bspline(values);
}

std::array<double, 2> height_range(const surface::CornerSquare& square, const Plane& plane) {
  const std::vector<Vector3d> points = square.points();
  std::array<double, 2> range{plane.height(points[0]), plane.height(points[0])};
  for (const Vector3d& p : points) {
    const double height = plane.height(p);
    range = {std::min(range[0], height), std::max(range[1], height)};
  }
  return range;
}

double crossing(const BezierCubic& column) {
  const Roots roots = sign_changes(column);
  if (!roots.empty()) return roots.front();
  // At the ends of a crossing rounding may hide the change of sign on the square's side.
  return std::abs(column[0]) < std::abs(column[3]) ? 0.0 : 1.0;
}

Breaks crossing_breaks(const BezierBicubic& height) {
  Breaks breaks;
  breaks.insert(0.0);
  breaks.insert(1.0);
  // For each u there is one crossing at most: it comes and goes through the sides v = 0 and 1 only.
  for (double v : {0.0, 1.0}) {
    for (double root : sign_changes(height.along_u(v))) breaks.insert(root);
  }
  return breaks;
}

}  // namespace hull::analysis

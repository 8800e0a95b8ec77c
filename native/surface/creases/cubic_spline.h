// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/pieces/bicubic.h"

namespace hull::surface {

// A point of a curve with its derivatives with respect to the curve's parameter; those beyond the
// order asked for are zero.
struct CurveJet {
  Vector3d point = Vector3d::Zero();
  Vector3d d1 = Vector3d::Zero(), d2 = Vector3d::Zero();
};

// A cubic B-spline curve over any non-decreasing knots, four more than control points. It is
// defined between the fourth knot and the fourth but last; ends need not be clamped.
class CubicSpline {
 public:
  // REQUIRES: at least four points, four more knots; those between begin() and end() are simple.
  CubicSpline(std::vector<Vector3d> points, std::vector<double> knots);

  const std::vector<Vector3d>& points() const { return points_; }
  const std::vector<double>& knots() const { return knots_; }
  double begin() const { return knots_[3]; }
  double end() const { return knots_[knots_.size() - 4]; }

  // Position and derivatives up to `order` (0, 1, 2). REQUIRES: begin() <= t <= end().
  CurveJet evaluate(double t, int order) const;

 private:
  std::vector<Vector3d> points_;
  std::vector<double> knots_;
};

}  // namespace hull::surface

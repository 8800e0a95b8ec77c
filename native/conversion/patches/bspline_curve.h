// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/vectors.h"

namespace hull::conversion {

// Knots from 0 to 1 that are nearer to each other are one: they differ by rounding.
inline constexpr double kSameKnot = 1e-12;

// A B-spline curve, clamped over [0, 1].
struct BSplineCurve {
  int degree = 3;
  std::vector<double> knots;     // count + degree + 1, clamped to 0 and 1
  std::vector<Vector3d> points;  // metres

  // Parameters outside [0, 1] are taken to the nearest end.
  Vector3d position(double t) const;
  double polygon_length() const;  // m, of the control polygon: an upper bound of the curve's

  // The same curve the other way.
  BSplineCurve reversed() const;
  // The same curve with one knot more at t, which is inside (0, 1), and a knot less often than the
  // degree.
  void insert_knot(double t);
  // Its part from `begin` to `end`, over [0, 1]. REQUIRES: 0 <= begin < end <= 1.
  BSplineCurve part(double begin, double end) const;
};

// A curve with any knots, as one over [0, 1] that starts and ends in its first and last control
// points. REQUIRES: degree + 1 knots more than points, ascending, and not all of those between the
// first degree and the last degree of them equal.
BSplineCurve clamped(BSplineCurve curve);

// The largest distance of points at equal parameters, m: sampled often enough, between all knots of
// both, that it is 0 to rounding only for curves that are equal.
double gap_between(const BSplineCurve& one, const BSplineCurve& two);

}  // namespace hull::conversion

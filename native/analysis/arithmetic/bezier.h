// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/arithmetic/small_list.h"

namespace hull::analysis {

// A cubic on [0, 1] by its Bézier coefficients.
using BezierCubic = std::array<double, 4>;

double evaluate(const BezierCubic& cubic, double t);

// Where the cubic changes sign in (0, 1], zero counting as positive, in rising order. Roots are
// exact to rounding; pairs closer than 1e-13 may be missed together.
using Roots = SmallList<double, 3>;
Roots sign_changes(const BezierCubic& cubic);

// The root in [0, 1] of a cubic that rises or falls, or has one sign change, by Newton's method in
// a bracket; the end where it is nearer to zero if its ends have the same sign.
double monotonic_root(const double* cubic);
inline double monotonic_root(const BezierCubic& cubic) { return monotonic_root(cubic.data()); }

// A bicubic on [0, 1]^2 by its Bézier coefficients, index 4 j + i: i along u.
class BezierBicubic {
 public:
  BezierBicubic() = default;
  explicit BezierBicubic(const std::array<double, 16>& coefficients) : c_(coefficients) {}
  // From the coefficients of a uniform B-spline span in the same order.
  static BezierBicubic from_bspline(const std::array<double, 16>& coefficients);

  double lowest() const;
  double highest() const;
  // The cubic in v at given u, and the one in u at given v.
  BezierCubic along_v(double u) const;
  BezierCubic along_u(double v) const;
  // Of the coefficients' differences along v (along u): bounds of a third of the derivative.
  std::array<double, 2> slope_bounds_v() const;
  std::array<double, 2> slope_bounds_u() const;
  BezierBicubic transposed() const;
  // Restricted to the quarter (i, j), i and j 0 or 1.
  BezierBicubic quarter(int i, int j) const;

 private:
  std::array<double, 16> c_{};
};

}  // namespace hull::analysis

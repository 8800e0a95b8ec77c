// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "conversion/patches/bspline_curve.h"
#include "surface/pieces/bicubic.h"

namespace hull::conversion {

// Knots of an open-uniform (clamped) B-spline over [0, 1]: both ends repeated degree + 1 times, the
// count - degree - 1 interior knots equally spaced and simple. REQUIRES: count > degree >= 1.
std::vector<double> open_uniform_knots(int degree, int count);

// A tensor-product B-spline surface (Greshake 2021, equation 7.1), clamped over [0, 1] x [0, 1].
//
// The sides are numbered like those of a cell, counter-clockwise seen from outside:
// 0: (0,0)->(1,0), 1: (1,0)->(1,1), 2: (1,1)->(0,1), 3: (0,1)->(0,0).
//
// REQUIRES of every member function: check() does not throw.
struct BSplinePatch {
  int degree_u = 3, degree_v = 3;
  std::vector<double> knots_u, knots_v;  // count + degree + 1 each, clamped to 0 and 1
  int count_u = 0, count_v = 0;          // control points along u and along v
  std::vector<Vector3d> control_points;  // metres; index i * count_v + j, i along u
  int cell = -1;                         // the cell of the surface it stands for, -1: none

  // Throws std::invalid_argument, naming the cell, if the sizes do not fit one another, a knot
  // vector is not clamped to [0, 1] and ascending, or a control point is not finite.
  void check() const;

  // Parameters outside [0, 1] are taken to the nearest end.
  Vector3d position(double u, double v) const;

  // With first and second derivatives; at an interior knot those from above where the two sides
  // differ (at 1, from below).
  surface::SurfaceJet evaluate(double u, double v) const;

  const Vector3d& control_point(int i, int j) const { return control_points[i * count_v + j]; }

  // The border curve along a side, in the side's direction: its control points, their indices in
  // control_points, its knots.
  std::vector<Vector3d> side_points(int side) const;
  std::vector<double> side_knots(int side) const;
  BSplineCurve side_curve(int side) const;
  double side_length(int side) const;  // m, of the control polygon: an upper bound of the curve's
  int side_index(int side, int i) const;
  // Of the control point i along side k from where it begins, and j off it, inwards.
  int corner_index(int k, int i, int j) const;
  int side_count(int side) const { return side % 2 == 0 ? count_u : count_v; }
  int side_degree(int side) const { return side % 2 == 0 ? degree_u : degree_v; }

  // The same surface with u and v exchanged: its normal points the other way.
  BSplinePatch transposed() const;
  // The same surface turned by a quarter: its side k is this one's side k + 1, with the same
  // direction and knots (but for rounding); the normal is the same.
  BSplinePatch turned() const;
};

// The B-spline basis functions of one degree over one knot vector, that do not vanish at t, with
// their first two derivatives: row d holds the d-th derivatives of functions first ... first +
// degree. The second order is zero below degree 2. REQUIRES: knots clamped to [0, 1].
struct BasisValues {
  int first = 0;
  Eigen::Matrix<double, 3, Eigen::Dynamic> rows;
};
BasisValues basis_values(const std::vector<double>& knots, int degree, double t);

}  // namespace hull::conversion

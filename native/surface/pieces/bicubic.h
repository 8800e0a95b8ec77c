// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "mesh/vectors.h"
#include "surface/eigenbasis/neighbourhood.h"

namespace hull::surface {

// A point of a surface with its first and second derivatives with respect to (u, v); those beyond
// the order asked for are zero.
struct SurfaceJet {
  Vector3d point = Vector3d::Zero();
  Vector3d du = Vector3d::Zero(), dv = Vector3d::Zero();
  Vector3d duu = Vector3d::Zero(), duv = Vector3d::Zero(), dvv = Vector3d::Zero();
};

// Unit vector along du x dv; zero where these are parallel or vanish.
Vector3d unit_normal(const Vector3d& du, const Vector3d& dv);

// Derivatives up to `order` to parameters that run 1/factor times as fast.
void scale_derivatives(SurfaceJet& jet, double factor, int order);

// Uniform cubic B-spline basis (Greshake 2021, 5.7) and its derivatives on the span [0, 1].
using Basis = std::array<double, 4>;
inline Basis cubic_basis(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, 2.0 / 3.0 - t * t + t * t * t / 2.0, 2.0 / 3.0 - s * s + s * s * s / 2.0,
          t * t * t / 6.0};
}

inline Basis cubic_basis_d1(double t) {
  const double s = 1.0 - t;
  return {-s * s / 2.0, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), t * t / 2.0};
}

inline Basis cubic_basis_d2(double t) {
  const double s = 1.0 - t;
  return {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t};
}

// Control points of one uniform bicubic B-spline span, index 4 (b + 1) + (a + 1): a along u.
using BicubicPoints = std::array<Vector3d, 16>;

// Position and derivatives up to `order` (0, 1, 2) at (u, v) in [0, 1]^2. Higher ones are left as
// they are in `jet`.
void evaluate_bicubic(const BicubicPoints& points, double u, double v, int order, SurfaceJet& jet);
inline SurfaceJet evaluate_bicubic(const BicubicPoints& points, double u, double v, int order) {
  SurfaceJet jet;
  evaluate_bicubic(points, u, v, order, jet);
  return jet;
}

// Fills the points beyond creases by reflection, 2 p - q (5.9: the ghost points that make the
// border a cubic B-spline curve of its own control points). `present` is grid_points().
template <class Value>
void fill_ghosts(std::array<Value, 16>& values, const std::array<int, 16>& present) {
  const auto missing = [&present](int index) { return present[index] == kNoPoint; };
  const auto reflect = [&values](int to, int step) {
    values[to] = values[to + step] * 2.0 - values[to + 2 * step];
  };
  // Index of (a, b) is 4 (b + 1) + (a + 1); the middle of a side tells whether the side is missing.
  const bool west = missing(4), east = missing(7), south = missing(1), north = missing(13);
  for (int row = south ? 1 : 0; row < (north ? 3 : 4); ++row) {
    if (west) reflect(4 * row, 1);
    if (east) reflect(4 * row + 3, -1);
  }
  for (int column = 0; column < 4; ++column) {
    if (south) reflect(column, 4);
    if (north) reflect(12 + column, -4);
  }
}

}  // namespace hull::surface

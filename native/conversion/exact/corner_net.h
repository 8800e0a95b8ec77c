// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "conversion/blocks/block_spans.h"

namespace hull::conversion {

// The control points of a graded patch that its corner square depends on, seen from the corner: u
// along the half-edge that leaves it, the square being [0, 1]². Knots along either direction are
// 0 0 0 0 2^-inner ... 1/2 1 k k + 1, where k is the end of the span beyond the square.
//
// Points (i, j) with i or j above `inner` are the surface's, for the patch is the surface outside
// the square. The others but (0, 0) may be chosen; (i, 0) and (0, j) are the sides' own.
struct CornerNet {
  int inner = 1;
  double beyond_u = 2.0, beyond_v = 2.0;
  std::vector<Vector3d> points;  // metres; index i * count() + j, i along u

  int count() const { return inner + 4; }
  const Vector3d& at(int i, int j) const { return points[i * count() + j]; }
  Vector3d& at(int i, int j) { return points[i * count() + j]; }

  // Position and first derivatives. REQUIRES: u and v are from 0 to 1.
  surface::SurfaceJet evaluate(double u, double v) const;
};

// Values and slopes of the functions along one direction at t in [0, 1].
struct CornerFunctions {
  std::array<double, kMostInner + 4> value{}, slope{};
};
CornerFunctions corner_functions(int inner, double beyond, double t);

// Of half-edge h of LimitSurface::cells(), whose origin is an irregular knot of its cell. The
// points that may be chosen continue what is around. REQUIRES: at least 2 halvings, 1 <= inner <=
// kMostInner.
CornerNet corner_net(const surface::LimitSurface& surface, int h, const Grading& grading);

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/immersion/shell_moments.h"
#include "analysis/immersion/span_rule.h"
#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// Points of a surface with normals times their quadrature weights.
struct ShellNodes {
  static constexpr int kCapacity = 64;
  alignas(32) std::array<double, kCapacity> x, y, z, nx, ny, nz;  // the first `count` are set
  int count = 0;

  void add(const Vector3d& p, const Vector3d& n);
};

// Adds the nodes' share to the moments, but for the error estimates.
void add_nodes(ShellNodes& nodes, ShellMoments& sum);

// A square [u, u + size] x [v, v + size] of a bicubic span, positions counted from `origin`.
struct SpanSquare {
  const surface::BicubicPoints& points;
  Vector3d origin = Vector3d::Zero();
  double u = 0.0, v = 0.0, size = 1.0;
};

// Moments of the square, without an estimate of the area's error.
ShellMoments span_moments(const SpanSquare& square, SpanRule rule);

// The same with the area, which is not polynomial, refined until its estimated error is below
// area_tolerance. REQUIRES: the rule has at least four nodes. Infinite: the area is not computed,
// and zero.
ShellMoments span_moments(const SpanSquare& square, SpanRule rule, double area_tolerance);

}  // namespace hull::analysis

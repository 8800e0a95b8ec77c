// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/limit_surface.h"

namespace hull::surface {

// Curvature of a surface at a point. Signs: a surface that bulges towards its normal's side, as a
// hull does into the water, is positive; a hollow one negative.
struct Curvature {
  double maximum = 0.0, minimum = 0.0;            // principal curvatures, 1/m; maximum >= minimum
  Vector3d maximum_direction = Vector3d::Zero();  // unit tangents of the lines of curvature; any
  Vector3d minimum_direction = Vector3d::Zero();  // two at right angles where both are equal
  bool defined = false;  // false where there is no tangent plane or a degenerate parametrisation
  bool at_irregular_knot = false;

  double gaussian() const { return maximum * minimum; }      // 1/m²
  double mean() const { return 0.5 * (maximum + minimum); }  // 1/m
};

// From the two fundamental forms of a jet of order 2; all zero and undefined where du x dv has no
// direction.
Curvature curvature_of(const SurfaceJet& jet);

// How far from an irregular knot, along u and v, curvature is taken instead of at the knot.
inline constexpr double kKnotOffset = 0x1p-20;

// At an irregular knot the surface is only C¹: its curvature diverges, vanishes, or depends on the
// direction of approach. There the value at (kKnotOffset, kKnotOffset) from the knot is returned,
// and flagged. REQUIRES: as LimitSurface::evaluate.
Curvature curvature(const LimitSurface& surface, int cell, double u, double v);

}  // namespace hull::surface

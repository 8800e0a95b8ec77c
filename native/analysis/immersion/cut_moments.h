// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/piece_moments.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// How closely the part of a span below the water is integrated.
struct CutRules {
  double zero;    // m: heights closer to the water than this count as none, which is above
  double volume;  // m³: estimated error of the volume in one part of a cut
  double area;    // m²: of its wetted area, and of that of a square below the water
  SpanRule span;  // of squares below the water, and across the water's surface in those it cuts
  int along;      // nodes along the water's surface, where integrands are no polynomials
};

// Moments of the part of a span below the water, positions counted from `origin`; `water` is given
// in the span's own coordinates. Between the exact crossings of the water's surface by Gauss
// quadrature: with an error of about 1e-13 of the span's share, estimated in volume_error (the
// error of the volume, height times oriented area along the normal) and area_error.
ShellMoments wet_moments(const surface::BicubicPoints& points, const Vector3d& origin,
                         const Plane& water, const CutRules& rules);

}  // namespace hull::analysis

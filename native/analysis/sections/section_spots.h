// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/section_point.h"
#include "surface/pieces/pieces.h"

namespace hull::analysis {

// The spot of a square at an irregular knot into which a section is not followed: `height` tells
// how far a point is above what cuts the surface, m.
template <class Height>
SectionSpot spot_of(const surface::LimitSurface& surface, const surface::CornerSquare& square,
                    double extent, const Height& height) {
  SectionPoint knot;
  knot.point = square.ring.limit();
  knot.cell = square.cell;
  // The knot is the corner of the square that it shares with its node; the others are regular.
  for (const double u : {square.u, square.u + square.size}) {
    for (const double v : {square.v, square.v + square.size}) {
      if (surface.is_irregular_knot(square.cell, u, v)) knot.uv = {u, v};
    }
  }
  return {knot, 2.0 * extent, height(knot.point)};
}

}  // namespace hull::analysis

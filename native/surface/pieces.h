// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "surface/limit_surface.h"

namespace hull {

// A square of a cell on which the surface is one uniform bicubic B-spline span.
struct SurfacePiece {
  int cell;
  double u, v, size;     // [u, u + size] x [v, v + size] of the cell
  BicubicPoints points;  // of the span, parametrised over the square along the cell's u and v
};

// The square that is left at an irregular knot after some rings of pieces.
struct CornerSquare {
  int cell;
  double u, v, size;
  std::vector<Vector3d> points;  // the surface lies in their convex hull
};

// Diagonal of the box around its points, m.
double extent_of(const CornerSquare& square);

// Visits pieces that together cover the cell but for squares at its irregular knots. `descend` is
// asked of each such square, from the whole cell or quadrant on, whether the next ring within it
// is wanted; it must at last say no (pieces end at 2^-60 of the cell).
void for_each_piece(const LimitSurface& surface, int cell,
                    const std::function<bool(const CornerSquare&)>& descend,
                    const std::function<void(const SurfacePiece&)>& visit);

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vectors.h"
#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// A place of a line on the surface, `along` the line's unit tangent there, and `out` what its
// change of bend counts by.
struct BendPlace {
  int cell;
  double u, v;
  Vector3d along, out;
};

// How the bends of lines on a surface change with its control points: sums over places of
// out · (change of the second derivative along the line, by arc length), as conditions of moves.
//
// A line is cut out of the surface by a plane, or it is one that goes with it, such as a crease.
// Where a plane cuts, the line's curvature changes by n · (second derivative of the moves along it,
// covariant) over the part of the surface's normal n across the line in its plane, to first order
// and without moves along the surface.
//
// Places in squares that PieceWeights leaves out at irregular points count nothing. Immutable.
class BendSums {
 public:
  explicit BendSums(const surface::LimitSurface& surface);

  // Of lines cut by planes. REQUIRES: as LimitSurface::position(); as many points as the surface.
  MoveCondition of_sections(const std::vector<Vector3d>& points,
                            const std::vector<BendPlace>& places) const;
  // Of lines that go with the surface.
  MoveCondition of_own_lines(const std::vector<Vector3d>& points,
                             const std::vector<BendPlace>& places) const;

 private:
  MoveCondition sum(const std::vector<Vector3d>& points, const std::vector<BendPlace>& places,
                    bool is_cut) const;

  surface::PieceWeights weights_;
};

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

#include "surface/pieces/bicubic.h"
#include "surface/surface_layout.h"

namespace hull::surface {

// A place in the tree of squares of a cell.
struct PlaceInCell {
  SurfaceNode node;  // a leaf or a corner
  double u, v;       // in the node's square
  double scale;      // d(u, v) of the node per d(u, v) of the cell
};

// REQUIRES: 0 <= cell < number of cells, u and v in [0, 1].
inline PlaceInCell find_place(const SurfaceLayout& layout, int cell, double u, double v) {
  PlaceInCell place{layout.root(cell), u, v, 1.0};
  while (place.node.kind == SurfaceNode::Kind::kSplit) {
    const int i = place.u >= 0.5, j = place.v >= 0.5;
    place = {layout.split(place.node.index)[2 * j + i], 2.0 * place.u - i, 2.0 * place.v - j,
             2.0 * place.scale};
  }
  return place;
}

// (u, v) seen from corner `turn` of the unit square (Greshake 2021, 4.3 without the scaling).
inline Eigen::Vector2d turned(int turn, double u, double v) {
  switch (turn) {
    case 0:
      return {u, v};
    case 1:
      return {v, 1.0 - u};
    case 2:
      return {1.0 - u, 1.0 - v};
    default:
      return {1.0 - v, u};
  }
}

// The place `t` of the way along a side of the unit square; side 0 is v = 0, the next ones follow
// round it as half-edges do.
inline Eigen::Vector2d on_square_side(int side, double t) { return turned((4 - side) % 4, t, 0.0); }

// Derivatives with respect to the square's own parameters from those seen from corner `turn`.
inline void turn_back(int turn, SurfaceJet& jet) {
  if (turn == 1 || turn == 3) {
    std::swap(jet.du, jet.dv);
    std::swap(jet.duu, jet.dvv);
    jet.duv = -jet.duv;
  }
  if (turn == 1 || turn == 2) jet.du = -jet.du;
  if (turn == 2 || turn == 3) jet.dv = -jet.dv;
}

}  // namespace hull::surface

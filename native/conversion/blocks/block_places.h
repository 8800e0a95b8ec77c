// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "conversion/blocks/block_layout.h"
#include "conversion/blocks/near_point.h"

namespace hull::conversion {

// The place `along` half-edge h of the cells and `across` it to its left, both from its begin; of
// h / 4, in [0, 1].
inline CellPoint place_beside_half_edge(int h, double along, double across) {
  switch (h % 4) {
    case 0:
      return {h / 4, along, across};
    case 1:
      return {h / 4, 1.0 - across, along};
    case 2:
      return {h / 4, 1.0 - along, 1.0 - across};
    default:
      return {h / 4, across, 1.0 - along};
  }
}

// The point of the surface there.
inline Vector3d point_on_half_edge(const surface::LimitSurface& surface, int h, double along) {
  const CellPoint place = place_beside_half_edge(h, along, 0.0);
  return surface.position(place.cell, place.u, place.v);
}

// Whether the surface is only C¹ in cell h / 4 where half-edge h begins.
inline bool begins_at_irregular_knot(const surface::LimitSurface& surface, int h) {
  const CellPoint place = place_beside_half_edge(h, 0.0, 0.0);
  return surface.is_irregular_knot(place.cell, place.u, place.v);
}

// Of each vertex of the cells the point of the surface, found once.
std::vector<Vector3d> vertex_points(const surface::LimitSurface& surface);

// The place of the surface that has (u, v) in [0, 1]^2 of a block's patch. REQUIRES: the block has
// cells.
CellPoint place_in_block(const Block& block, double u, double v);

// Whether side k of the part of a block that is meant is on the whole block's side k, and from
// where to where it is there, as shares of it in the side's direction.
bool is_on_side(const Block& block, int k);
std::array<double, 2> part_of_side(const Block& block, int k);

// Where a patch has the place s of its side k.
inline std::array<double, 2> place_on_side(int k, double s) {
  return k == 0   ? std::array<double, 2>{s, 0.0}
         : k == 1 ? std::array<double, 2>{1.0, s}
         : k == 2 ? std::array<double, 2>{1.0 - s, 1.0}
                  : std::array<double, 2>{0.0, 1.0 - s};
}

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull::conversion {

// A rectangle of cells without a crease, or a point where the surface is only C¹, inside.
struct Block {
  int count_u = 0, count_v = 0;  // cells along u and v
  // Of each cell the half-edge (of LimitSurface::cells()) that is its side v = 0 in the block's
  // orientation; index i * count_v + j, i along u.
  std::vector<int> sides;
  // The part of the rectangle that is meant, as shares of it: all, but where patches are divided.
  double begin_u = 0.0, end_u = 1.0, begin_v = 0.0, end_v = 1.0;

  int side(int i, int j) const { return sides[i * count_v + j]; }

  // The half-edges along side k (numbered as those of a BSplinePatch), in its direction.
  std::vector<int> half_edges(const mesh::Topology& cells, int k) const;
};

// The cells of a surface, cut into few blocks.
//
// Cuts are the borders and creases, and straight lines along the cells' sides from every irregular
// point to the next cut: a motorcycle graph (Eppstein, Goodrich, Kim & Tamstorf 2008), all of whose
// faces are rectangles. So irregular points are corners of blocks, and a block's corner may lie
// within its neighbour's side. Every line adds one block, wherever it ends, but for a line that
// ends at another irregular point, where it makes another one unnecessary; such lines are cut
// first. What has neither irregular points nor borders, as tubes, is cut along a line of it.
// What would be beside itself then, as rings are, is halved.
struct BlockLayout {
  explicit BlockLayout(const surface::LimitSurface& surface);

  std::vector<Block> blocks;
  std::vector<char> cuts;  // per edge of cells()
};

// A bound, from counting alone, below which no such layout comes: every rectangle has four corners.
// In a region between creases a cell's corner at an irregular point is one, and so is a border's
// convex corner; a line that ends in a cut makes two more, and one that joins two irregular points
// none. All pairs that a straight line joins are taken for joined, whether or not such lines cross.
int least_block_count(const surface::LimitSurface& surface);

}  // namespace hull::conversion

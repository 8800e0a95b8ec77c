// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/block_layout.h"
#include "surface/pieces.h"

namespace hull {

// Of each vertex of LimitSurface::cells() how often the knots are halved there, if it is irregular.
using Gradings = std::vector<int>;

// A square of a block on which the surface is one bicubic span; in the block's coordinates, in
// which every cell is a unit square.
struct BlockSpan {
  double u, v, size;
  BicubicPoints points;
  bool is_in_corner;  // in one of the corner squares
};

// The spans of a block, and those of a few rings more of the *corner squares*: the squares of
// 2^-grading of a cell that are left at irregular corners.
class BlockSpans {
 public:
  BlockSpans(const LimitSurface& surface, const Block& block, const Gradings& gradings);

  // The lines between spans outside the corner squares, rising, from 0 to the number of cells; and
  // those through the middles of the corner squares. Some blocks need these, beside modified edges;
  // all have them, so that neighbours have the same knots where their borders are not exact.
  const std::vector<double>& lines_u() const { return lines_u_; }
  const std::vector<double>& lines_v() const { return lines_v_; }

  // The span that holds a point that is on none of the lines between spans; null in the smallest
  // squares at irregular corners.
  const BlockSpan* at(double u, double v) const;

 private:
  int count_v_;
  std::vector<std::vector<BlockSpan>> spans_;  // of each cell
  std::vector<double> lines_u_, lines_v_;
};

}  // namespace hull

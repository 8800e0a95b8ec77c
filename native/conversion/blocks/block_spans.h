// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/blocks/block_layout.h"
#include "surface/pieces/pieces.h"

namespace hull::conversion {

// How knots are halved around an irregular point: `halvings` times, and `inner` times more within
// the corner squares of 2^-halvings of a cell that are left.
struct Grading {
  int halvings = 3;
  int inner = 1;

  bool operator==(const Grading&) const = default;
};

inline constexpr int kMostInner = 3;

// Of each vertex of LimitSurface::cells(); what is there for regular ones does not matter.
using Gradings = std::vector<Grading>;

// A square of a block on which the surface is one bicubic span; in the block's coordinates, in
// which every cell is a unit square.
struct BlockSpan {
  double u, v, size;
  surface::BicubicPoints points;
  bool is_in_corner;  // in one of the corner squares
};

// The spans of a block, and those of a few rings more of the *corner squares*: the squares that are
// left at irregular corners.
class BlockSpans {
 public:
  BlockSpans(const surface::LimitSurface& surface, const Block& block, const Gradings& gradings);
  BlockSpans(const BlockSpans&) = delete;

  // The lines between spans outside the corner squares, rising, from 0 to the number of cells; and
  // the inner ones of the corner squares.
  const std::vector<double>& lines_u() const { return lines_u_; }
  const std::vector<double>& lines_v() const { return lines_v_; }

  // A place in each interval between lines, on none between spans; the same seen from both ends, so
  // that neighbours that run the other way choose the same spans.
  const std::vector<double>& places_u() const { return places_u_; }
  const std::vector<double>& places_v() const { return places_v_; }

  // The span that holds place k along u and l along v; null in the smallest squares at irregular
  // corners.
  const BlockSpan* at(int k, int l) const { return at_places_[k * places_v_.size() + l]; }

 private:
  void find_spans_at_places();

  std::vector<BlockSpan> spans_;
  std::vector<double> lines_u_, lines_v_, places_u_, places_v_;
  std::vector<const BlockSpan*> at_places_;  // index k * places_v_.size() + l
};

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/block_spans.h"

#include <algorithm>
#include <cmath>

namespace hull {
namespace {

using pieces_internal::turned_points;
using pieces_internal::turned_square;

constexpr int kDeeperRings = 2;

bool contains(const DomainSquare& square, const SurfacePiece& piece) {
  return piece.u >= square.u && piece.u < square.u + square.size && piece.v >= square.v &&
         piece.v < square.v + square.size;
}

// The corner of the cell that a smaller square lies at.
int corner_of(const CornerSquare& square) {
  const bool at_begin_u = square.u == 0.0, at_begin_v = square.v == 0.0;
  return at_begin_u ? (at_begin_v ? 0 : 3) : (at_begin_v ? 1 : 2);
}

void sort_unique(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

BlockSpans::BlockSpans(const LimitSurface& surface, const Block& block, const Gradings& gradings)
    : count_v_(block.count_v), spans_(block.sides.size()) {
  const Topology& cells = surface.cells();
  for (int i = 0; i < block.count_u; ++i) {
    for (int j = 0; j < block.count_v; ++j) {
      const int side = block.side(i, j), turn_back = (4 - side % 4) % 4;
      std::vector<DomainSquare> corners;
      const auto descend = [&](const CornerSquare& square) {
        if (square.size == 1.0) return true;
        const int grading = gradings[cells.origin(4 * square.cell + corner_of(square))];
        if (square.size == std::exp2(-grading)) {
          corners.push_back({square.u, square.v, square.size});
        }
        return square.size > std::exp2(-grading - kDeeperRings);
      };
      for_each_piece(surface, side / 4, descend, [&](const SurfacePiece& piece) {
        const bool is_in_corner = std::any_of(corners.begin(), corners.end(),
                                              [&](const auto& c) { return contains(c, piece); });
        const DomainSquare seen = turned_square(turn_back, {piece.u, piece.v, piece.size});
        const BlockSpan span{i + seen.u, j + seen.v, seen.size,
                             turned_points(turn_back, piece.points), is_in_corner};
        spans_[i * count_v_ + j].push_back(span);
        if (is_in_corner) return;
        for (double end : {span.u, span.u + span.size}) lines_u_.push_back(end);
        for (double end : {span.v, span.v + span.size}) lines_v_.push_back(end);
      });
      for (const DomainSquare& square : corners) {
        const DomainSquare seen = turned_square(turn_back, square);
        lines_u_.push_back(i + seen.u + 0.5 * seen.size);
        lines_v_.push_back(j + seen.v + 0.5 * seen.size);
      }
    }
  }
  sort_unique(lines_u_);
  sort_unique(lines_v_);
}

const BlockSpan* BlockSpans::at(double u, double v) const {
  for (const BlockSpan& span : spans_[static_cast<int>(u) * count_v_ + static_cast<int>(v)]) {
    if (u > span.u && u < span.u + span.size && v > span.v && v < span.v + span.size) return &span;
  }
  return nullptr;
}

}  // namespace hull

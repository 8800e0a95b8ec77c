// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/block_spans.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hull::conversion {
namespace {

using surface::pieces_internal::turned_points;
using surface::pieces_internal::turned_square;

// A corner square of a cell.
struct GradedCorner {
  surface::DomainSquare square;
  int inner;
};

bool contains(const surface::DomainSquare& square, const surface::SurfacePiece& piece) {
  // Pieces are wholly in a corner square or out of it, so their own corners tell.
  return piece.u >= square.u && piece.u < square.u + square.size && piece.v >= square.v &&
         piece.v < square.v + square.size;
}

// The corner of the cell that a smaller square lies at.
int corner_of(const surface::CornerSquare& square) {
  const bool at_begin_u = square.u == 0.0, at_begin_v = square.v == 0.0;
  return at_begin_u ? (at_begin_v ? 0 : 3) : (at_begin_v ? 1 : 2);
}

void sort_unique(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Lines are at multiples of powers of two: none passes there.
std::vector<double> places_between(const std::vector<double>& lines) {
  std::vector<double> result;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const bool is_first_half = lines[k] + lines[k + 1] < lines.front() + lines.back();
    // Not in the middle, through which lines of smaller spans pass.
    result.push_back(lines[k] + (is_first_half ? 0.6 : 0.4) * (lines[k + 1] - lines[k]));
  }
  return result;
}

}  // namespace

BlockSpans::BlockSpans(const surface::LimitSurface& surface, const Block& block,
                       const Gradings& gradings) {
  const mesh::Topology& cells = surface.cells();
  for (int i = 0; i < block.count_u; ++i) {
    for (int j = 0; j < block.count_v; ++j) {
      // The cell as the block sees it, whose side v = 0 is any of the cell's own.
      const int side = block.side(i, j), turn_back = (4 - side % 4) % 4;
      std::vector<GradedCorner> corners;
      const auto descend = [&](const surface::CornerSquare& square) {
        // The whole cell is no corner square, whatever the grading.
        if (square.size == 1.0) return true;
        const Grading& grading = gradings[cells.origin(4 * square.cell + corner_of(square))];
        // Sizes are powers of two, and equal to the last bit.
        if (square.size == std::exp2(-grading.halvings)) {
          corners.push_back({{square.u, square.v, square.size}, grading.inner});
        }
        // One ring more than there are knots within: control points there need spans on either
        // side.
        return square.size > std::exp2(-grading.halvings - grading.inner - 1);
      };
      surface::for_each_piece(surface, side / 4, descend, [&](const surface::SurfacePiece& piece) {
        const bool is_in_corner = std::any_of(corners.begin(), corners.end(), [&](const auto& c) {
          return contains(c.square, piece);
        });
        const surface::DomainSquare seen = turned_square(turn_back, {piece.u, piece.v, piece.size});
        const BlockSpan span{i + seen.u, j + seen.v, seen.size,
                             turned_points(turn_back, piece.points), is_in_corner};
        spans_.push_back(span);
        if (is_in_corner) return;
        for (double end : {span.u, span.u + span.size}) lines_u_.push_back(end);
        for (double end : {span.v, span.v + span.size}) lines_v_.push_back(end);
      });
      for (const GradedCorner& corner : corners) {
        const surface::DomainSquare seen = turned_square(turn_back, corner.square);
        // Halved towards the corner, which is at a corner of the cell.
        const bool at_begin_u = seen.u == 0.0, at_begin_v = seen.v == 0.0;
        for (int k = 1; k <= corner.inner; ++k) {
          const double size = std::exp2(-k) * seen.size;
          lines_u_.push_back(at_begin_u ? i + size : i + 1.0 - size);
          lines_v_.push_back(at_begin_v ? j + size : j + 1.0 - size);
        }
      }
    }
  }
  sort_unique(lines_u_);
  sort_unique(lines_v_);
  places_u_ = places_between(lines_u_);
  places_v_ = places_between(lines_v_);
  find_spans_at_places();
}

void BlockSpans::find_spans_at_places() {
  at_places_.assign(places_u_.size() * places_v_.size(), nullptr);
  const auto within = [](const std::vector<double>& places, double begin, double size) {
    // A span may hold several places, as lines of its neighbours run through it.
    const auto first = std::upper_bound(places.begin(), places.end(), begin);
    return std::pair(first - places.begin(),
                     std::lower_bound(first, places.end(), begin + size) - places.begin());
  };
  for (const BlockSpan& span : spans_) {
    const auto [u0, u1] = within(places_u_, span.u, span.size);
    const auto [v0, v1] = within(places_v_, span.v, span.size);
    for (auto k = u0; k < u1; ++k) {
      for (auto l = v0; l < v1; ++l) at_places_[k * places_v_.size() + l] = &span;
    }
  }
}

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/piece_weights.h"

#include <cmath>
#include <utility>

#include "surface/pieces/bicubic_basis.h"
#include "surface/pieces/square_weights.h"
#include "surface/place_in_cell.h"

namespace hull::surface {
namespace {

Eigen::VectorXd product(const Eigen::MatrixXd& rows, const Basis& along_s, const Basis& along_t) {
  return rows.transpose() * bicubic_basis(along_s, along_t);
}

}  // namespace

PieceWeights::PieceWeights(const LimitSurface& surface)
    : layout_(surface.shared_layout()),
      of_leaf_(layout_->leaf_count(), -1),
      of_corner_(layout_->corner_count(), -1) {
  PointWeights weights(surface);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    add_node(cell, layout_->root(cell), 1.0, weights);
  }
}

void PieceWeights::add_node(int cell, const SurfaceNode& node, double size, PointWeights& weights) {
  if (node.kind == SurfaceNode::Kind::kCorner) return add_corner(cell, node.index, size, weights);
  if (node.kind == SurfaceNode::Kind::kSplit) {
    for (const SurfaceNode& child : layout_->split(node.index)) {
      add_node(cell, child, 0.5 * size, weights);
    }
    return;
  }
  of_leaf_[node.index] = piece_count();
  SquareWeights square = leaf_weights(*layout_, node.index, weights);
  pieces_.push_back({cell, size, std::move(square.points), std::move(square.rows)});
}

void PieceWeights::add_corner(int cell, int corner, double size, PointWeights& weights) {
  SquareWeights square = corner_weights(*layout_, corner, weights);
  const CornerBasis& basis = layout_->basis(corner);
  of_corner_[corner] = piece_count();
  for (int ring = 0; ring < kPlainRings; ++ring) {
    for (const RingSegment& segment : basis.segments()) {
      // Ring after ring, so that find() can count where a segment of a ring is.
      pieces_.push_back({cell, std::ldexp(segment.size, -ring) * size, square.points,
                         segment.rows * square.rows});
    }
    // One subdivision on: the weights of the square that is half as large.
    square.rows = basis.matrix() * square.rows;
  }
}

std::optional<PieceWeights::Place> PieceWeights::find(int cell, double u, double v) const {
  const PlaceInCell place = find_place(*layout_, cell, u, v);
  if (place.node.kind == SurfaceNode::Kind::kLeaf) {
    return Place{of_leaf_[place.node.index], place.u, place.v};
  }
  const CornerBasis& basis = layout_->basis(place.node.index);
  Eigen::Vector2d seen = turned(place.node.turn, place.u, place.v);
  for (int ring = 0; ring < kPlainRings; ++ring, seen *= 2.0) {
    // Ring k fills what is between 2^-k and 2^-(k+1) of the square; doubling brings it to ring 0.
    if (seen.maxCoeff() < 0.5) continue;
    for (int s = 0; s < basis.segment_count(); ++s) {
      const RingSegment& segment = basis.segments()[s];
      // Segments have dyadic places and sizes, so this is exact, and nothing falls between two of
      // them.
      const double a = (seen.x() - segment.u) / segment.size;
      const double b = (seen.y() - segment.v) / segment.size;
      if (a < 0.0 || a > 1.0 || b < 0.0 || b > 1.0) continue;
      return Place{of_corner_[place.node.index] + ring * basis.segment_count() + s, a, b};
    }
  }
  return std::nullopt;
}

Eigen::VectorXd PieceWeights::weights(const Place& place) const {
  return product(pieces_[place.piece].rows, cubic_basis(place.s), cubic_basis(place.t));
}

PieceWeights::Jet PieceWeights::jet(const Place& place) const {
  const Eigen::MatrixXd& rows = pieces_[place.piece].rows;
  const Basis s0 = cubic_basis(place.s), s1 = cubic_basis_d1(place.s), s2 = cubic_basis_d2(place.s);
  const Basis t0 = cubic_basis(place.t), t1 = cubic_basis_d1(place.t), t2 = cubic_basis_d2(place.t);
  return {product(rows, s0, t0), product(rows, s1, t0), product(rows, s0, t1),
          product(rows, s2, t0), product(rows, s1, t1), product(rows, s0, t2)};
}

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/piece_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "surface/pieces/bicubic_basis.h"
#include "surface/place_in_cell.h"

namespace hull::surface {
namespace {

// Weights of refined points as a dense matrix over those control points that have any.
struct Rows {
  std::vector<int> points;
  Eigen::MatrixXd weights;
};

Rows dense_rows(const std::vector<const WeightRow*>& rows) {
  std::map<int, int> column;
  for (const WeightRow* row : rows) {
    for (const PointWeight& w : row->entries()) column[w.point] = 0;
  }
  Rows dense;
  for (auto& [point, index] : column) {
    index = static_cast<int>(dense.points.size());
    dense.points.push_back(point);
  }
  dense.weights.setZero(static_cast<Eigen::Index>(rows.size()),
                        static_cast<Eigen::Index>(column.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const PointWeight& w : rows[i]->entries()) {
      dense.weights(static_cast<Eigen::Index>(i), column[w.point]) = w.weight;
    }
  }
  return dense;
}

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
  const std::array<int, 16>& points = layout_->leaf_points(node.index);
  std::vector<const WeightRow*> present;
  for (int point : points) {
    if (point != kNoPoint) present.push_back(&weights.refined(point));
  }
  const Rows dense = dense_rows(present);
  std::array<Eigen::RowVectorXd, 16> span;
  Eigen::Index row = 0;
  for (int i = 0; i < 16; ++i) {
    span[i].setZero(dense.weights.cols());
    if (points[i] != kNoPoint) span[i] = dense.weights.row(row++);
  }
  // Beyond creases the missing points are reflections of those that are there, as for the points
  // themselves; a linear rule, so it serves for rows of weights too.
  fill_ghosts(span, points);
  Eigen::MatrixXd rows(16, dense.weights.cols());
  for (int i = 0; i < 16; ++i) rows.row(i) = span[i];
  of_leaf_[node.index] = piece_count();
  pieces_.push_back({cell, size, dense.points, std::move(rows)});
}

void PieceWeights::add_corner(int cell, int corner, double size, PointWeights& weights) {
  std::vector<const WeightRow*> outer;
  for (int point : layout_->corner_points(corner)) outer.push_back(&weights.refined(point));
  Rows square = dense_rows(outer);
  const CornerBasis& basis = layout_->basis(corner);
  of_corner_[corner] = piece_count();
  for (int ring = 0; ring < kPlainRings; ++ring) {
    for (const RingSegment& segment : basis.segments()) {
      pieces_.push_back({cell, std::ldexp(segment.size, -ring) * size, square.points,
                         segment.rows * square.weights});
    }
    // One subdivision on: the weights of the square that is half as large.
    square.weights = basis.matrix() * square.weights;
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

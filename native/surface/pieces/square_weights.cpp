// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/square_weights.h"

#include <algorithm>
#include <array>

#include "surface/pieces/bicubic.h"

namespace hull::surface {
namespace {

// Refined points as rows; a row without entries where there is none.
SquareWeights dense_rows(const std::vector<const WeightRow*>& rows) {
  SquareWeights dense;
  for (const WeightRow* row : rows) {
    for (const PointWeight& w : row->entries()) dense.points.push_back(w.point);
  }
  std::ranges::sort(dense.points);
  dense.points.erase(std::unique(dense.points.begin(), dense.points.end()), dense.points.end());
  dense.rows.setZero(static_cast<Eigen::Index>(rows.size()),
                     static_cast<Eigen::Index>(dense.points.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto column = dense.points.begin();
    for (const PointWeight& w : rows[i]->entries()) {
      // Entries rise as the columns do, so the search goes on where it was.
      column = std::lower_bound(column, dense.points.end(), w.point);
      dense.rows(static_cast<Eigen::Index>(i), column - dense.points.begin()) = w.weight;
    }
  }
  return dense;
}

}  // namespace

SquareWeights leaf_weights(const SurfaceLayout& layout, int leaf, PointWeights& weights) {
  static const WeightRow kNone;
  const std::array<int, 16>& points = layout.leaf_points(leaf);
  std::vector<const WeightRow*> rows;
  for (int point : points) {
    // References to rows stay good while others are added.
    rows.push_back(point == kNoPoint ? &kNone : &weights.refined(point));
  }
  SquareWeights square = dense_rows(rows);
  if (std::ranges::find(points, kNoPoint) == points.end()) return square;
  // Beyond creases the missing points are reflections of those that are there, as for the points
  // themselves; a linear rule, so it serves for rows of weights too.
  std::array<Eigen::RowVectorXd, 16> span;
  for (int i = 0; i < 16; ++i) span[i] = square.rows.row(i);
  fill_ghosts(span, points);
  for (int i = 0; i < 16; ++i) square.rows.row(i) = span[i];
  return square;
}

SquareWeights corner_weights(const SurfaceLayout& layout, int corner, PointWeights& weights) {
  std::vector<const WeightRow*> rows;
  for (int point : layout.corner_points(corner)) rows.push_back(&weights.refined(point));
  return dense_rows(rows);
}

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/surface_squares.h"

#include <algorithm>
#include <map>

#include "surface/pieces/point_weights.h"

namespace hull::surface {
namespace {

// Weights of the points that there are in the 16 of a leaf.
Eigen::MatrixXd leaf_spread(const std::array<int, 16>& points) {
  // The ghost rule is run on rows of the unit matrix, one column for each point that is there.
  const auto count = 16 - std::ranges::count(points, kNoPoint);
  std::array<Eigen::RowVectorXd, 16> rows;
  Eigen::Index next = 0;
  for (int i = 0; i < 16; ++i) {
    rows[i] = Eigen::RowVectorXd::Zero(count);
    if (points[i] != kNoPoint) rows[i][next++] = 1.0;
  }
  fill_ghosts(rows, points);
  Eigen::MatrixXd spread(16, count);
  for (int i = 0; i < 16; ++i) spread.row(i) = rows[i];
  return spread;
}

}  // namespace

WeightRows refined_weights(const LimitSurface& surface) {
  const SurfaceLayout& layout = surface.layout();
  const std::size_t refined = layout.cells().vertex_count() + layout.second_half_edges().size() +
                              layout.third_half_edges().size();
  std::vector<char> is_used(refined, 0);
  for (int leaf = 0; leaf < layout.leaf_count(); ++leaf) {
    for (int point : layout.leaf_points(leaf)) {
      if (point != kNoPoint) is_used[point] = 1;
    }
  }
  for (int corner = 0; corner < layout.corner_count(); ++corner) {
    for (int point : layout.corner_points(corner)) is_used[point] = 1;
  }
  PointWeights weights(surface);
  std::vector<int> begins{0}, columns;
  std::vector<double> values;
  // Points come in order, so the compressed form is written as it is.
  for (std::size_t point = 0; point < refined; ++point) {
    if (is_used[point]) {
      for (const PointWeight& w : weights.refined(static_cast<int>(point)).entries()) {
        columns.push_back(w.point);
        values.push_back(w.weight);
      }
    }
    begins.push_back(static_cast<int>(columns.size()));
  }
  return Eigen::Map<const WeightRows>(
      static_cast<Eigen::Index>(refined), static_cast<Eigen::Index>(surface.mesh().points().size()),
      static_cast<Eigen::Index>(values.size()), begins.data(), columns.data(), values.data());
}

class SurfaceSquares::Builder {
 public:
  explicit Builder(SurfaceSquares& squares) : squares_(squares), layout_(*squares.layout_) {}

  void build() {
    for (int cell = 0; cell < layout_.cells().face_count(); ++cell) {
      add_node(cell, layout_.root(cell));
    }
  }

 private:
  void add_node(int cell, const SurfaceNode& node) {
    switch (node.kind) {
      case SurfaceNode::Kind::kLeaf:
        add_leaf(cell, node.index);
        return;
      case SurfaceNode::Kind::kCorner:
        add(cell, node.index, corner_kind(layout_.basis(node.index)),
            layout_.corner_points(node.index));
        return;
      case SurfaceNode::Kind::kSplit:
        for (const SurfaceNode& child : layout_.split(node.index)) add_node(cell, child);
    }
  }

  void add_leaf(int cell, int leaf) {
    const std::array<int, 16>& points = layout_.leaf_points(leaf);
    std::vector<int> there;
    std::copy_if(points.begin(), points.end(), std::back_inserter(there),
                 [](int point) { return point != kNoPoint; });
    std::array<bool, 16> is_there;
    std::ranges::transform(points, is_there.begin(), [](int point) { return point != kNoPoint; });
    const auto [known, is_new] = leaf_kinds_.try_emplace(is_there, kind_count());
    if (is_new) squares_.kinds_.push_back({nullptr, leaf_spread(points), {}});
    add(cell, leaf, known->second, there);
  }

  int corner_kind(const CornerBasis& basis) {
    // A layout has one basis for all corners of a kind, so its address tells.
    const auto [known, is_new] = corner_kinds_.try_emplace(&basis, kind_count());
    if (is_new) squares_.kinds_.push_back({&basis, {}, {}});
    return known->second;
  }

  void add(int cell, int index, int kind, const std::vector<int>& points) {
    squares_.kinds_[kind].squares.push_back(squares_.count());
    squares_.squares_.push_back({cell, index, kind, static_cast<int>(squares_.points_.size()),
                                 static_cast<int>(points.size())});
    squares_.points_.insert(squares_.points_.end(), points.begin(), points.end());
  }

  int kind_count() const { return static_cast<int>(squares_.kinds_.size()); }

  SurfaceSquares& squares_;
  const SurfaceLayout& layout_;
  std::map<std::array<bool, 16>, int> leaf_kinds_;
  std::map<const CornerBasis*, int> corner_kinds_;
};

SurfaceSquares::SurfaceSquares(const LimitSurface& surface)
    : layout_(surface.shared_layout()), weights_(refined_weights(surface)) {
  Builder(*this).build();
}

}  // namespace hull::surface

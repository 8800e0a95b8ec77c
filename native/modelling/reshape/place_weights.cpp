// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/place_weights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "modelling/gauss_rule.h"
#include "surface/pieces/bicubic_basis.h"
#include "surface/pieces/square_weights.h"

namespace hull::modelling {
namespace {

// A Gauss rule in the unit square: weights of a bicubic piece's points at its places, in positions
// and in derivatives along s and along t, rows; and the places' shares.
struct SquareRule {
  explicit SquareRule(const GaussRule& rule) {
    using surface::bicubic_basis, surface::cubic_basis, surface::cubic_basis_d1;
    for (Eigen::MatrixXd& weights : rows) weights.resize(rule.count * rule.count, 16);
    for (int i = 0; i < rule.count; ++i) {
      for (int j = 0; j < rule.count; ++j) {
        const auto k = static_cast<Eigen::Index>(shares.size());
        const double s = rule.points[i], t = rule.points[j];
        rows[0].row(k) = bicubic_basis(cubic_basis(s), cubic_basis(t));
        rows[1].row(k) = bicubic_basis(cubic_basis_d1(s), cubic_basis(t));
        rows[2].row(k) = bicubic_basis(cubic_basis(s), cubic_basis_d1(t));
        shares.push_back(rule.weights[i] * rule.weights[j]);
      }
    }
  }

  Eigen::MatrixXd rows[3];
  std::vector<double> shares;
};

const GaussRule& rule_of(int per_side) {
  if (per_side == 2) return kTwoPoints;
  if (per_side == 3) return kThreePoints;
  throw std::invalid_argument("There are 2 or 3 places a side of a piece, not " +
                              std::to_string(per_side) + ".");
}

bool is_same(const mesh::Topology& a, const mesh::Topology& b) {
  if (a.half_edge_count() != b.half_edge_count() || a.vertex_count() != b.vertex_count() ||
      a.face_count() != b.face_count()) {
    return false;
  }
  for (int h = 0; h < a.half_edge_count(); ++h) {
    if (a.origin(h) != b.origin(h) || a.face(h) != b.face(h) || a.twin(h) != b.twin(h) ||
        a.is_crease(h) != b.is_crease(h)) {
      return false;
    }
  }
  for (int v = 0; v < a.vertex_count(); ++v) {
    if (a.kind(v) != b.kind(v)) return false;
  }
  return true;
}

}  // namespace

// Walks through the cells in the order in which PlaceWeights has them.
class PlaceWeights::Builder {
 public:
  Builder(PlaceWeights& places, const surface::LimitSurface& surface, const GaussRule& rule)
      : places_(places), surface_(surface), refined_(surface), plain_(rule), ringed_(kTwoPoints) {}

  void build() {
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      cell_ = cell;
      add_node(surface_.layout().root(cell));
    }
    take(0, places_.at_);
    take(1, places_.along_s_);
    take(2, places_.along_t_);
  }

 private:
  // The rows that a CornerBasis gives of the places of its rings and at the knot, by its points.
  struct CornerRows {
    Eigen::MatrixXd weights[3];  // of positions and derivatives
    std::vector<double> shares;
  };

  void add_node(const surface::SurfaceNode& node) {
    switch (node.kind) {
      case surface::SurfaceNode::Kind::kLeaf:
        add_places(surface::leaf_weights(surface_.layout(), node.index, refined_), plain_.rows,
                   plain_.shares);
        return;
      case surface::SurfaceNode::Kind::kCorner:
        add_corner(node.index);
        return;
      case surface::SurfaceNode::Kind::kSplit:
        for (const auto& child : surface_.layout().split(node.index)) add_node(child);
    }
  }

  void add_corner(int corner) {
    const surface::CornerBasis& basis = surface_.layout().basis(corner);
    const CornerRows& rows = rows_of(basis);
    add_places(surface::corner_weights(surface_.layout(), corner, refined_), rows.weights,
               rows.shares);
    const std::size_t per_ring = basis.segments().size() * ringed_.shares.size();
    places_.knots_.push_back({places_.count() - 1, static_cast<int>(per_ring)});
  }

  // Many corners have one basis: the rings' rows are multiplied out once.
  const CornerRows& rows_of(const surface::CornerBasis& basis) {
    const auto [known, is_new] = corner_rows_.try_emplace(&basis);
    CornerRows& rows = known->second;
    if (!is_new) return rows;
    const auto per_piece = static_cast<Eigen::Index>(ringed_.shares.size());
    const Eigen::Index pieces = surface::kPlainRings * basis.segment_count();
    for (Eigen::MatrixXd& weights : rows.weights) {
      weights.setZero(per_piece * pieces + 1, basis.point_count());
    }
    Eigen::MatrixXd square = Eigen::MatrixXd::Identity(basis.point_count(), basis.point_count());
    Eigen::Index first = 0;
    for (int ring = 0; ring < surface::kPlainRings; ++ring) {
      for (const surface::RingSegment& segment : basis.segments()) {
        const Eigen::MatrixXd piece = segment.rows * square;
        for (int k = 0; k < 3; ++k) {
          rows.weights[k].middleRows(first, per_piece) = ringed_.rows[k] * piece;
        }
        first += per_piece;
        rows.shares.insert(rows.shares.end(), ringed_.shares.begin(), ringed_.shares.end());
      }
      square = basis.matrix() * square;
    }
    // The limit's weights, applied to the smallest square for accuracy.
    const Eigen::MatrixXd& left = basis.spectrum().left;
    const Eigen::MatrixXd ring = square.topRows(left.rows()).rowwise() - square.row(0);
    rows.weights[0].row(first) = square.row(0) + left.col(0).transpose() * ring;
    rows.shares.push_back(0.0);
    return rows;
  }

  // Places in one square; `rows` are their weights of its points.
  void add_places(const surface::SquareWeights& square, const Eigen::MatrixXd (&rows)[3],
                  const std::vector<double>& shares) {
    using Product = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto count = static_cast<Eigen::Index>(shares.size()), points = square.rows.cols();
    for (int k = 0; k < 3; ++k) {
      const std::size_t begin = values_[k].size();
      values_[k].resize(begin + static_cast<std::size_t>(count * points));
      Eigen::Map<Product>(values_[k].data() + begin, count, points).noalias() =
          rows[k] * square.rows;
    }
    for (double share : shares) {
      columns_.insert(columns_.end(), square.points.begin(), square.points.end());
      places_.cells_.push_back(cell_);
      places_.shares_.push_back(share);
      ends_.push_back(static_cast<int>(columns_.size()));
    }
  }

  // Rows of the same columns: each point once and in rising order, as the squares have them.
  void take(int which, Rows& rows) const {
    const std::vector<double>& values = values_[which];
    rows.resize(places_.count(), static_cast<Eigen::Index>(surface_.mesh().points().size()));
    rows.resizeNonZeros(static_cast<Eigen::Index>(values.size()));
    rows.outerIndexPtr()[0] = 0;
    std::ranges::copy(ends_, rows.outerIndexPtr() + 1);
    std::ranges::copy(columns_, rows.innerIndexPtr());
    std::ranges::copy(values, rows.valuePtr());
  }

  PlaceWeights& places_;
  const surface::LimitSurface& surface_;
  surface::PointWeights refined_;
  const SquareRule plain_, ringed_;
  std::unordered_map<const surface::CornerBasis*, CornerRows> corner_rows_;
  std::vector<int> columns_, ends_;  // of the rows
  std::vector<double> values_[3];    // of positions and derivatives
  int cell_ = 0;
};

PlaceWeights::PlaceWeights(const surface::LimitSurface& surface, int per_side)
    : layout_(surface.shared_layout()), mesh_(surface.mesh()) {
  Builder(*this, surface, rule_of(per_side)).build();
  find_slots();
}

bool PlaceWeights::fit(const surface::LimitSurface& surface) const {
  if (surface.shared_layout() == layout_) return true;
  return surface.scheme() == layout_->scheme() &&
         is_same(surface.mesh().topology(), mesh_.topology());
}

void PlaceWeights::find_slots() {
  const int *begin = at_.outerIndexPtr(), *column = at_.innerIndexPtr();
  for (int k = 0; k < count(); ++k) {
    const int size = begin[k + 1] - begin[k];
    if (!blocks_.empty()) {
      Block& last = blocks_.back();
      if (last.size == size &&
          std::equal(column + begin[k], column + begin[k + 1], column + begin[last.first])) {
        ++last.count;
        continue;
      }
    }
    blocks_.push_back({k, 1, size, {}});
  }
  std::vector<std::vector<int>> near(at_.cols());
  for (const Block& block : blocks_) {
    const int* points = column + begin[block.first];
    for (int i = 0; i < block.size; ++i) {
      near[points[i]].insert(near[points[i]].end(), points, points + block.size);
    }
  }
  std::vector<int> begins{0}, rows;
  for (std::vector<int>& own : near) {
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    rows.insert(rows.end(), own.begin(), own.end());
    begins.push_back(static_cast<int>(rows.size()));
  }
  const std::vector<double> zeros(rows.size(), 0.0);
  pattern_ =
      Eigen::Map<const Matrix>(at_.cols(), at_.cols(), static_cast<Eigen::Index>(rows.size()),
                               begins.data(), rows.data(), zeros.data());
  for (Block& block : blocks_) {
    const int* points = column + begin[block.first];
    for (int j = 0; j < block.size; ++j) {
      auto slot = rows.begin() + begins[points[j]];
      for (int i = 0; i < block.size; ++i) {
        slot = std::lower_bound(slot, rows.begin() + begins[points[j] + 1], points[i]);
        block.slots.push_back(static_cast<int>(slot - rows.begin()));
      }
    }
  }
}

PlaceWeights::Matrix PlaceWeights::form(const Eigen::VectorXd& diagonal) const {
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix form = pattern_;
  for (const Block& block : blocks_) {
    const Eigen::Map<const Dense> weights(at_.valuePtr() + at_.outerIndexPtr()[block.first],
                                          block.count, block.size);
    const Eigen::MatrixXd own =
        weights.transpose() * diagonal.segment(block.first, block.count).asDiagonal() * weights;
    for (Eigen::Index k = 0; k < own.size(); ++k) {
      form.valuePtr()[block.slots[k]] += own.data()[k];
    }
  }
  return form;
}

}  // namespace hull::modelling

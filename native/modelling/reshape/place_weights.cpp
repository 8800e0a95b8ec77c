// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/place_weights.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "modelling/gauss_rule.h"
#include "surface/pieces/bicubic_basis.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {
namespace {

using Basis16 = Eigen::Matrix<double, 16, Eigen::Dynamic>;

// A Gauss rule in the unit square: the B-spline basis and its derivatives at its places, columns,
// and the places' shares.
struct SquareRule {
  explicit SquareRule(const GaussRule& rule) {
    const int count = rule.count * rule.count;
    all.resize(16, 3 * count);
    for (int i = 0; i < rule.count; ++i) {
      for (int j = 0; j < rule.count; ++j) {
        const int k = static_cast<int>(shares.size());
        const double s = rule.points[i], t = rule.points[j];
        fill(k, surface::cubic_basis(s), surface::cubic_basis(t));
        fill(count + k, surface::cubic_basis_d1(s), surface::cubic_basis(t));
        fill(2 * count + k, surface::cubic_basis(s), surface::cubic_basis_d1(t));
        shares.push_back(rule.weights[i] * rule.weights[j]);
      }
    }
  }

  void fill(int k, const surface::Basis& s, const surface::Basis& t) {
    all.col(k) = surface::bicubic_basis(s, t);
  }

  Basis16 all;  // the basis, then the derivatives along s, then those along t
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

// Walks through the pieces in the order in which PieceWeights has them.
class PlaceWeights::Builder {
 public:
  Builder(PlaceWeights& places, const surface::LimitSurface& surface, const GaussRule& rule)
      : places_(places),
        surface_(surface),
        pieces_(surface),
        deep_(surface),
        plain_(rule),
        ringed_(kTwoPoints) {}

  void build() {
    reserve();
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      cell_ = cell;
      add_node(surface_.layout().root(cell), {0.0, 0.0}, 1.0);
    }
    take(at_, places_.at_);
    take(along_s_, places_.along_s_);
    take(along_t_, places_.along_t_);
  }

 private:
  // What the places of most pieces take.
  void reserve() {
    std::size_t entries = 0;
    for (int i = 0; i < pieces_.piece_count(); ++i) entries += pieces_.piece(i).points.size();
    entries *= ringed_.shares.size();
    for (std::vector<double>* values : {&at_, &along_s_, &along_t_}) values->reserve(entries);
    columns_.reserve(entries);
  }

  void add_node(const surface::SurfaceNode& node, const Eigen::Vector2d& begin, double size) {
    switch (node.kind) {
      case surface::SurfaceNode::Kind::kLeaf:
        add_piece(plain_);
        return;
      case surface::SurfaceNode::Kind::kCorner:
        add_corner(node, begin, size);
        return;
      case surface::SurfaceNode::Kind::kSplit:
        break;
    }
    const auto& children = surface_.layout().split(node.index);
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector2d step(0.5 * size * (k % 2), 0.5 * size * (k / 2));
      add_node(children[k], begin + step, 0.5 * size);
    }
  }

  void add_corner(const surface::SurfaceNode& node, const Eigen::Vector2d& begin, double size) {
    const int segments = surface_.layout().basis(node.index).segment_count();
    for (int k = 0; k < surface::kPlainRings * segments; ++k) add_piece(ringed_);
    const bool right = node.turn == 1 || node.turn == 2, above = node.turn >= 2;
    const Eigen::Vector2d uv = begin + size * Eigen::Vector2d(right, above);
    places_.knots_.push_back({places_.count(), segments * static_cast<int>(ringed_.shares.size())});
    for (const surface::PointWeight& w : deep_.at(cell_, uv.x(), uv.y())) {
      columns_.push_back(w.point);
      at_.push_back(w.weight);
    }
    along_s_.resize(columns_.size(), 0.0);
    along_t_.resize(columns_.size(), 0.0);
    end_place(columns_.size(), 0.0);
  }

  void add_piece(const SquareRule& rule) {
    const surface::PieceWeights::Piece& piece = pieces_.piece(piece_++);
    weights_.noalias() = piece.rows.transpose() * rule.all;
    const auto third = static_cast<std::ptrdiff_t>(piece.points.size() * rule.shares.size());
    const double* values = weights_.data();
    at_.insert(at_.end(), values, values + third);
    along_s_.insert(along_s_.end(), values + third, values + 2 * third);
    along_t_.insert(along_t_.end(), values + 2 * third, values + 3 * third);
    for (double share : rule.shares) {
      columns_.insert(columns_.end(), piece.points.begin(), piece.points.end());
      end_place(columns_.size(), share);
    }
  }

  void end_place(std::size_t end, double share) {
    places_.cells_.push_back(cell_);
    places_.shares_.push_back(share);
    ends_.push_back(static_cast<int>(end));
  }

  // Rows of the same columns: each point once and in rising order, as the pieces have them.
  void take(const std::vector<double>& values, Rows& rows) const {
    rows.resize(places_.count(), static_cast<Eigen::Index>(surface_.mesh().points().size()));
    rows.resizeNonZeros(static_cast<Eigen::Index>(values.size()));
    rows.outerIndexPtr()[0] = 0;
    std::ranges::copy(ends_, rows.outerIndexPtr() + 1);
    std::ranges::copy(columns_, rows.innerIndexPtr());
    std::ranges::copy(values, rows.valuePtr());
  }

  PlaceWeights& places_;
  const surface::LimitSurface& surface_;
  const surface::PieceWeights pieces_;
  surface::PointWeights deep_;
  const SquareRule plain_, ringed_;
  std::vector<int> columns_, ends_;  // of the rows
  Eigen::MatrixXd weights_;          // of a piece's places
  std::vector<double> at_, along_s_, along_t_;
  int cell_ = 0, piece_ = 0;
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

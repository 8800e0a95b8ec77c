// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/place_weights.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/gauss.h"
#include "modelling/reshape/square_pieces.h"
#include "surface/pieces/bicubic_basis.h"

namespace hull::modelling {
namespace {

// A Gauss rule in the unit square: weights of a bicubic piece's points at its places, in positions
// and in derivatives along s and along t, rows; and the places' shares.
struct SquareRule {
  explicit SquareRule(const analysis::ShortGaussRule& rule) {
    using surface::bicubic_basis, surface::cubic_basis, surface::cubic_basis_d1;
    for (Eigen::MatrixXd& weights : rows) weights.resize(rule.count * rule.count, 16);
    for (int i = 0; i < rule.count; ++i) {
      for (int j = 0; j < rule.count; ++j) {
        const auto k = static_cast<Eigen::Index>(shares.size());
        const double s = rule.nodes[i], t = rule.nodes[j];
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

const analysis::ShortGaussRule& rule_of(int per_side) {
  if (per_side == 2) return analysis::kTwoNodes;
  if (per_side == 3) return analysis::kThreeNodes;
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

// Squares of a kind are taken so many at a time: matrices of their points that stay in the cache.
constexpr std::size_t kBatch = 32;

template <class Take>
void for_each_batch(const std::vector<int>& squares, const Take& take) {
  for (std::size_t first = 0; first < squares.size(); first += kBatch) {
    take(std::span<const int>(squares).subspan(first, std::min(kBatch, squares.size() - first)));
  }
}

// Of each square as many columns as there are numbers a point, such as x, y and z.
template <int kColumns>
Eigen::Index columns_of(std::span<const int> batch) {
  return kColumns * static_cast<Eigen::Index>(batch.size());
}

template <int kColumns, class Row>
auto numbers_of(Eigen::MatrixXd& columns, Row row, std::size_t square) {
  return columns.block<1, kColumns>(static_cast<Eigen::Index>(row),
                                    kColumns * static_cast<Eigen::Index>(square));
}

}  // namespace

// Takes the squares in the order in which PlaceWeights has them.
class PlaceWeights::Builder {
 public:
  Builder(PlaceWeights& places, const analysis::ShortGaussRule& rule)
      : places_(places), plain_(rule), ringed_(analysis::kTwoNodes) {}

  void build() {
    const surface::SurfaceSquares& squares = places_.squares();
    for (const surface::SurfaceSquares::Kind& kind : squares.kinds()) {
      places_.kinds_.push_back(rows_of(kind));
    }
    for (int square = 0; square < squares.count(); ++square) {
      const KindRows& rows = places_.kind_of(square);
      // Places are numbered as they come: square after square, in each ring after ring, the knot
      // last.
      places_.first_.push_back(places_.count());
      places_.cells_.insert(places_.cells_.end(), rows.shares.size(), squares.cell(square));
      places_.shares_.insert(places_.shares_.end(), rows.shares.begin(), rows.shares.end());
      const surface::CornerBasis* basis = squares.kinds()[squares.kind(square)].basis;
      if (!basis) continue;
      const std::size_t per_ring = basis->segments().size() * ringed_.shares.size();
      places_.knots_.push_back({places_.count() - 1, static_cast<int>(per_ring)});
    }
  }

 private:
  KindRows rows_of(const surface::SurfaceSquares::Kind& kind) const {
    const SquareRule& rule = kind.basis ? ringed_ : plain_;
    const std::vector<Eigen::MatrixXd> pieces = square_pieces(kind);
    const auto per_piece = static_cast<Eigen::Index>(rule.shares.size());
    const auto count = per_piece * static_cast<Eigen::Index>(pieces.size());
    KindRows rows;
    for (int k = 0; k < 3; ++k) {
      // A corner has one place more, its knot, where derivatives stay zero.
      rows.rows[k].setZero(kind.basis ? count + 1 : count, kind.point_count());
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        rows.rows[k].middleRows(static_cast<Eigen::Index>(i) * per_piece, per_piece) =
            rule.rows[k] * pieces[i];
      }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      rows.shares.insert(rows.shares.end(), rule.shares.begin(), rule.shares.end());
    }
    if (kind.basis) {
      rows.rows[0].row(count) = knot_row(*kind.basis);
      rows.shares.push_back(0.0);
    }
    return rows;
  }

  // The limit's weights, applied to the smallest square for accuracy.
  static Eigen::RowVectorXd knot_row(const surface::CornerBasis& basis) {
    Eigen::MatrixXd square = basis.matrix();
    for (int ring = 1; ring < surface::kPlainRings; ++ring) square = basis.matrix() * square;
    const Eigen::MatrixXd& left = basis.spectrum().left;
    // From the first point on, as weights of a small square are nearly those of its knot.
    const Eigen::MatrixXd around = square.topRows(left.rows()).rowwise() - square.row(0);
    return square.row(0) + left.col(0).transpose() * around;
  }

  PlaceWeights& places_;
  const SquareRule plain_, ringed_;
};

PlaceWeights::PlaceWeights(const surface::LimitSurface& surface, int per_side)
    : mesh_(surface.mesh()), layout_(surface.shared_layout()), forms_(surface) {
  Builder(*this, rule_of(per_side)).build();
}

bool PlaceWeights::fit(const surface::LimitSurface& surface) const {
  // Copies of a surface share their layout: mostly nothing needs to be compared.
  if (surface.shared_layout() == layout_) return true;
  return surface.scheme() == layout_->scheme() &&
         is_same(surface.mesh().topology(), mesh_.topology());
}

template <std::size_t kAsked, int kColumns>
std::array<NumberRows<kColumns>, kAsked> PlaceWeights::applied(
    const NumberRows<kColumns>& control, const std::array<int, kAsked>& asked) const {
  // Two products instead of one with the weights multiplied out: control points to the refined
  // points, which squares share, and these to places.
  const NumberRows<kColumns> refined = squares().weights() * control;
  std::array<NumberRows<kColumns>, kAsked> results;
  for (NumberRows<kColumns>& result : results) result.resize(count(), kColumns);
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    for_each_batch(squares().kinds()[k].squares, [&](std::span<const int> batch) {
      Eigen::MatrixXd points(kinds_[k].rows[0].cols(), columns_of<kColumns>(batch));
      Eigen::MatrixXd places(kinds_[k].rows[0].rows(), points.cols());
      for (std::size_t b = 0; b < batch.size(); ++b) {
        const std::span<const int> own = squares().points(batch[b]);
        for (std::size_t i = 0; i < own.size(); ++i) {
          numbers_of<kColumns>(points, i, b) = refined.row(own[i]);
        }
      }
      for (std::size_t one = 0; one < kAsked; ++one) {
        // Points are gathered once for all that is asked of them.
        places.noalias() = kinds_[k].rows[asked[one]] * points;
        for (std::size_t b = 0; b < batch.size(); ++b) {
          for (Eigen::Index i = 0; i < places.rows(); ++i) {
            results[one].row(first_[batch[b]] + i) = numbers_of<kColumns>(places, i, b);
          }
        }
      }
    });
  }
  return results;
}

template <int kColumns>
NumberRows<kColumns> PlaceWeights::taken_back(const NumberRows<kColumns>& by_places) const {
  // The same products transposed, the last first. Squares add to points that they share: one after
  // another, in an order that is always the same.
  NumberRows<kColumns> refined =
      NumberRows<kColumns>::Zero(squares().weights().rows(), Eigen::Index{kColumns});
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    const Eigen::MatrixXd& rows = kinds_[k].rows[0];
    for_each_batch(squares().kinds()[k].squares, [&](std::span<const int> batch) {
      Eigen::MatrixXd places(rows.rows(), columns_of<kColumns>(batch));
      Eigen::MatrixXd points(rows.cols(), places.cols());
      for (std::size_t b = 0; b < batch.size(); ++b) {
        for (Eigen::Index i = 0; i < rows.rows(); ++i) {
          numbers_of<kColumns>(places, i, b) = by_places.row(first_[batch[b]] + i);
        }
      }
      points.noalias() = rows.transpose() * places;
      for (std::size_t b = 0; b < batch.size(); ++b) {
        const std::span<const int> own = squares().points(batch[b]);
        for (std::size_t i = 0; i < own.size(); ++i) {
          refined.row(own[i]) += numbers_of<kColumns>(points, i, b);
        }
      }
    });
  }
  return squares().weights().transpose() * refined;
}

// All that the header's functions ask for.
template std::array<VectorRows, 1> PlaceWeights::applied(const VectorRows&,
                                                         const std::array<int, 1>&) const;
template std::array<VectorRows, 2> PlaceWeights::applied(const VectorRows&,
                                                         const std::array<int, 2>&) const;
template std::array<VectorRows, 3> PlaceWeights::applied(const VectorRows&,
                                                         const std::array<int, 3>&) const;
template std::array<NumberRows<1>, 1> PlaceWeights::applied(const NumberRows<1>&,
                                                            const std::array<int, 1>&) const;
template VectorRows PlaceWeights::taken_back(const VectorRows&) const;
template NumberRows<1> PlaceWeights::taken_back(const NumberRows<1>&) const;

PlaceWeights::Matrix PlaceWeights::form(const Eigen::VectorXd& diagonal) const {
  return forms_.sum([&](int square, Eigen::MatrixXd& form) {
    const Eigen::MatrixXd& rows = kind_of(square).rows[0];
    form.noalias() +=
        rows.transpose() * (diagonal.segment(first_[square], rows.rows()).asDiagonal() * rows);
  });
}

PlaceWeights::SquareRows PlaceWeights::rows(int square) const {
  const surface::WeightRows& weights = squares().weights();
  SquareRows result{first_[square], {}, {}};
  for (int point : squares().points(square)) {
    for (surface::WeightRows::InnerIterator w(weights, point); w; ++w) {
      result.points.push_back(static_cast<int>(w.col()));
    }
  }
  std::ranges::sort(result.points);
  result.points.erase(std::unique(result.points.begin(), result.points.end()), result.points.end());
  const Eigen::MatrixXd& by_own = kind_of(square).rows[0];
  result.rows.setZero(by_own.rows(), static_cast<Eigen::Index>(result.points.size()));
  Eigen::Index i = 0;
  for (int point : squares().points(square)) {
    for (surface::WeightRows::InnerIterator w(weights, point); w; ++w) {
      // Several of the square's points may have a control point in common.
      const auto column = std::ranges::lower_bound(result.points, w.col()) - result.points.begin();
      result.rows.col(column) += w.value() * by_own.col(i);
    }
    ++i;
  }
  return result;
}

}  // namespace hull::modelling

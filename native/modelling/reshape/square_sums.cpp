// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/square_sums.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mesh/groups.h"
#include "mesh/tolerances.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {
namespace {

// Of a normal's y: what is nearer to zero is square to the plane, of control points in single
// precision too.
constexpr double kSquare = 1e-4;
// Places on a piece's side: what is to vanish there is a polynomial of the seventh degree.
constexpr int kPlaces = 8;
// Of rows of unit length: what is shorter follows from others, but for rounding, which leaves some
// 1e-13. Beside knots of many faces the last of the rows are of 1e-10.
constexpr double kFollows = 1e-12;

// Weights of the derivative of what the control points carry, in a direction of the surface.
using Row = std::map<int, double>;

class Finder {
 public:
  Finder(const surface::LimitSurface& surface, const std::vector<TiedPoint>& ties)
      : surface_(surface), t_(surface.mesh().topology()) {
    for (const TiedPoint& tie : ties) leader_[tie.point] = tie.leader;
  }

  std::vector<MoveCondition> sums() {
    std::vector<Row> rows;
    for (int h = 0; h < t_.half_edge_count(); ++h) {
      if (t_.twin(h) >= 0 || !is_in_plane(h) || !is_in_plane(t_.next(h))) continue;
      if (!is_near_irregular(h)) continue;
      if (!pieces_) pieces_.emplace(surface_);
      const std::vector<Row> own = rows_of(h);
      rows.insert(rows.end(), own.begin(), own.end());
    }
    std::vector<MoveCondition> sums;
    for (const Row& row : independent(rows)) {
      for (int axis : {0, 2}) {
        MoveCondition sum;
        for (const auto& [point, weight] : row) {
          sum.points.push_back(point);
          sum.slopes.emplace_back(weight * Vector3d::Unit(axis));
        }
        sums.push_back(std::move(sum));
      }
    }
    return sums;
  }

 private:
  bool is_in_plane(int h) const {
    return std::abs(surface_.mesh().points()[t_.origin(h)].y()) <=
           kOnCentrePlane * surface_.mesh().size();
  }

  // Whether the border point at the half-edge's origin has other than two quadrilaterals.
  bool is_irregular(int h) const {
    const int other = t_.twin(t_.prev(h));
    return other < 0 || t_.kind_at(h) != mesh::VertexKind::kCrease || t_.is_crease(t_.prev(h)) ||
           t_.twin(t_.prev(other)) >= 0 || t_.face_size(t_.face(h)) != 4 ||
           t_.face_size(t_.face(other)) != 4;
  }

  // The next half-edge along the border, or the one before.
  int following(int h) const {
    // Around the point, face by face, to the half-edge that has no face beyond.
    int next = t_.next(h);
    while (t_.twin(next) >= 0) next = t_.next(t_.twin(next));
    return next;
  }
  int preceding(int h) const {
    int before = t_.prev(h);
    while (t_.twin(before) >= 0) before = t_.prev(t_.twin(before));
    return before;
  }

  // The surface along the half-edge depends on what is at its ends and at the points beyond.
  bool is_near_irregular(int h) const {
    const int next = following(h);
    return is_irregular(h) || is_irregular(next) || is_irregular(preceding(h)) ||
           is_irregular(following(next));
  }

  // Of the places along the half-edge; none where the surface is not square to the plane there.
  std::vector<Row> rows_of(int h) const {
    std::vector<Row> rows;
    for (int half = 0; half < 2; ++half) {
      double end = 1.0;
      for (int ring = 0; ring < surface::kPlainRings; ++ring, end *= 0.5) {
        for (int k = 0; k < kPlaces; ++k) {
          // Of a cell's side, from the knot that the half's cell has at (0, 0): the ring is between
          // half of `end` and `end`. Regular cells are one piece, with more places than it needs.
          const double along = 0.5 * end * (1.0 + (k + 0.5) / kPlaces);
          const auto place =
              half == 0 ? pieces_->find(h, along, 0.0) : pieces_->find(t_.next(h), 0.0, along);
          if (!place) continue;
          std::optional<Row> row = row_at(*place);
          if (!row) return {};
          if (!row->empty()) rows.push_back(std::move(*row));
        }
      }
    }
    return rows;
  }

  // None where the surface is not square to the plane; empty where nothing is asked beside the
  // ties.
  std::optional<Row> row_at(const surface::PieceWeights::Place& place) const {
    const std::vector<int>& points = pieces_->piece(place.piece).points;
    const surface::PieceWeights::Jet jet = pieces_->jet(place);
    Eigen::Matrix<double, 3, 2> slopes = Eigen::Matrix<double, 3, 2>::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      slopes.col(0) += jet.ds[i] * surface_.mesh().points()[points[k]];
      slopes.col(1) += jet.dt[i] * surface_.mesh().points()[points[k]];
    }
    const Vector3d normal = surface::unit_normal(slopes.col(0), slopes.col(1));
    if (normal.isZero(0.0) || std::abs(normal.y()) > kSquare) return std::nullopt;
    const Eigen::Matrix2d level{{slopes(0, 0), slopes(0, 1)}, {slopes(2, 0), slopes(2, 1)}};
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(level, Eigen::ComputeFullV);
    // The direction in which x and z change least: the singular value 0, but for rounding.
    const Eigen::Vector2d across = svd.matrixV().col(1);
    Row row;
    double whole = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const double weight = across[0] * jet.ds[i] + across[1] * jet.dt[i];
      const auto tied = leader_.find(points[k]);
      // A tied point moves along x and z as its leader: in the sums they are one.
      row[tied == leader_.end() ? points[k] : tied->second] += weight;
      whole = std::max(whole, std::abs(weight));
    }
    // Where ties say all the weights of a point and its leader cancel: nothing is left but
    // rounding.
    std::erase_if(row, [&](const auto& entry) { return std::abs(entry.second) < 1e-13 * whole; });
    double squares = 0.0;
    for (const auto& [point, weight] : row) squares += weight * weight;
    // Of unit length, as what counts as rounding is told by that.
    for (auto& [point, weight] : row) weight /= std::sqrt(squares);
    return row;
  }

  // Orthonormal rows with the same meaning; rows that share points go together.
  std::vector<Row> independent(const std::vector<Row>& rows) const {
    mesh::Groups groups(t_.vertex_count());
    for (const Row& row : rows) {
      for (const auto& [point, weight] : row) groups.join(point, row.begin()->first);
    }
    std::map<int, std::vector<const Row*>> clusters;
    for (const Row& row : rows) clusters[groups.find(row.begin()->first)].push_back(&row);
    std::vector<Row> result;
    for (const auto& [group, own] : clusters) add_independent(own, result);
    return result;
  }

  static void add_independent(const std::vector<const Row*>& rows, std::vector<Row>& result) {
    std::map<int, Eigen::Index> column;
    for (const Row* row : rows) {
      for (const auto& [point, weight] : *row) column[point] = 0;
    }
    Eigen::Index count = 0;
    for (auto& [point, index] : column) index = count++;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(rows.size()));
    for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
      for (const auto& [point, weight] : *rows[i]) matrix(column.at(point), i) = weight;
    }
    // Rows as columns: the first columns of Q span them, orthonormal, as far as the rank goes.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    qr.setThreshold(kFollows);
    const Eigen::MatrixXd spanning =
        qr.householderQ() * Eigen::MatrixXd::Identity(count, qr.rank());
    for (Eigen::Index i = 0; i < spanning.cols(); ++i) {
      Row row;
      for (const auto& [point, index] : column) row[point] = spanning(index, i);
      result.push_back(std::move(row));
    }
  }

  const surface::LimitSurface& surface_;
  const mesh::Topology& t_;
  std::optional<surface::PieceWeights> pieces_;  // once they are needed: they take long
  std::map<int, int> leader_;
};

}  // namespace

std::vector<MoveCondition> square_sums(const surface::LimitSurface& surface,
                                       const std::vector<TiedPoint>& ties) {
  return Finder(surface, ties).sums();
}

}  // namespace hull::modelling

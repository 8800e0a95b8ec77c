// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/bend_change.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/gauss.h"

namespace hull::modelling {
namespace {

// Of sines: less is no area, and no direction along the ship.
constexpr double kFlatPiece = 1e-6, kLooksAhead = 1e-3;
// Of what bends across the surface.
constexpr double kAlongSurface = 0.1;

using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic>;

// How a surface bends at a place: a frame, and rows of weights that give the covariant second
// derivatives along it, 11, √2 · 12 and 22, of what control points of a piece carry.
struct PlaceBend {
  Vector3d along, across, normal;
  double area;
  Rows rows;
};

// s, t, ss, st, tt.
using Jet = Eigen::Matrix<double, 5, Eigen::Dynamic>;

Jet jet_rows(const surface::PieceWeights::Jet& jet) {
  Jet rows(5, jet.ds.size());
  rows << jet.ds.transpose(), jet.dt.transpose(), jet.dss.transpose(), jet.dst.transpose(),
      jet.dtt.transpose();
  return rows;
}

std::optional<PlaceBend> bend_of(const Jet& jet, const Eigen::MatrixX3d& points) {
  const Eigen::Matrix<double, 5, 3> at = jet * points;
  const Vector3d s = at.row(0), t = at.row(1);
  PlaceBend bend;
  bend.normal = s.cross(t);
  bend.area = bend.normal.norm();
  if (!(bend.area > kFlatPiece * s.norm() * t.norm())) return std::nullopt;
  bend.normal /= bend.area;
  // A frame that both surfaces have, whichever way their sides run.
  bend.along = Vector3d::UnitX() - bend.normal.x() * bend.normal;
  if (!(bend.along.norm() > kLooksAhead)) return std::nullopt;
  bend.along.normalize();
  bend.across = bend.normal.cross(bend.along);
  // Parts along s and t of a vector along the surface.
  Eigen::Matrix2d metric;
  metric << s.dot(s), s.dot(t), s.dot(t), t.dot(t);
  const Eigen::Matrix2d inverse = metric.inverse();
  const auto parts = [&](const Vector3d& v) -> Eigen::Vector2d {
    return inverse * Eigen::Vector2d(v.dot(s), v.dot(t));
  };
  Rows covariant = jet.bottomRows(3);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d symbols = parts(at.row(2 + k).transpose());
    covariant.row(k) -= symbols[0] * jet.row(0) + symbols[1] * jet.row(1);
  }
  const Eigen::Vector2d one = parts(bend.along), two = parts(bend.across);
  // The second derivative along p and q, by ss, st and tt.
  const auto both = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return Eigen::RowVector3d(p[0] * q[0], p[0] * q[1] + p[1] * q[0], p[1] * q[1]);
  };
  Eigen::Matrix3d frame;
  frame << both(one, one), std::sqrt(2.0) * both(one, two), both(two, two);
  bend.rows = frame * covariant;
  return bend;
}

Eigen::MatrixX3d carried(const std::vector<int>& which, const std::vector<Vector3d>& points) {
  Eigen::MatrixX3d own(static_cast<Eigen::Index>(which.size()), 3);
  for (Eigen::Index i = 0; i < own.rows(); ++i) own.row(i) = points[which[i]].transpose();
  return own;
}

void check_before(const BendsBefore& before, std::size_t count) {
  if (before.points.size() != count) {
    throw std::invalid_argument("The surface before must have " + std::to_string(count) +
                                " control points, not " + std::to_string(before.points.size()) +
                                ".");
  }
  if (before.emphasised.size() != before.factors.size()) {
    throw std::invalid_argument("There must be a factor for each place that is emphasised.");
  }
  const auto is_sound = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!is_sound(before.least) || !std::ranges::all_of(before.factors, is_sound)) {
    throw std::invalid_argument("The least bend and factors must be above zero, and not infinite.");
  }
}

double emphasis(const BendsBefore& before, const Vector3d& place) {
  double factor = 1.0;
  for (std::size_t i = 0; i < before.emphasised.size(); ++i) {
    if ((before.emphasised[i] - place).squaredNorm() > before.reach * before.reach) continue;
    factor = std::max(factor, before.factors[i]);
  }
  return factor;
}

// Sums of one piece: form, gradient and constant of the moves of its points.
struct PieceSums {
  Eigen::MatrixXd form;
  Eigen::VectorXd gradient;
  double constant = 0.0;

  explicit PieceSums(std::size_t points) {
    const auto size = 3 * static_cast<Eigen::Index>(points);
    form.setZero(size, size);
    gradient.setZero(size);
  }

  // (residual + direction · Σ row_i Δ_i)², weighed.
  void add(double weight, double residual, const Vector3d& direction,
           const Eigen::RowVectorXd& row) {
    Eigen::VectorXd slopes(gradient.size());
    for (Eigen::Index i = 0; i < row.size(); ++i) slopes.segment<3>(3 * i) = row[i] * direction;
    form.selfadjointView<Eigen::Lower>().rankUpdate(slopes, weight);
    gradient += weight * residual * slopes;
    constant += weight * residual * residual;
  }

  void add_place(const PlaceBend& now, const PlaceBend& was, const Eigen::MatrixX3d& points,
                 const Eigen::MatrixX3d& points_before, double least, double weight) {
    // To first order the normal's own turn changes nothing: what is covariant has no part along the
    // surface.
    const Eigen::Vector3d h = now.rows * points * now.normal;
    const Eigen::Vector3d b = was.rows * points_before * was.normal;
    for (int k = 0; k < 3; ++k) {
      const double share = least * least / (b[k] * b[k] + least * least);
      add(weight * share, h[k] - b[k], now.normal, now.rows.row(k));
      add(weight * kAlongSurface * kAlongSurface, 0.0, now.along, now.rows.row(k));
      add(weight * kAlongSurface * kAlongSurface, 0.0, now.across, now.rows.row(k));
    }
  }
};

}  // namespace

QuadraticEnergy bend_change(const std::vector<Vector3d>& points, const BendsBefore& before,
                            const surface::PieceWeights& weights, const std::vector<int>& pieces,
                            const std::vector<char>& counts) {
  check_before(before, points.size());
  const auto size = 3 * static_cast<Eigen::Index>(points.size());
  QuadraticEnergy energy{{size, size}, Eigen::VectorXd::Zero(size)};
  std::vector<Eigen::Triplet<double>> entries;
  const auto& [count, nodes, shares] = analysis::kThreeNodes;
  for (int piece : pieces) {
    const std::vector<int>& which = weights.piece(piece).points;
    const Eigen::MatrixX3d own = carried(which, points), was = carried(which, before.points);
    PieceSums sums(which.size());
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const surface::PieceWeights::Jet jet = weights.jet({piece, nodes[i], nodes[j]});
        const Jet rows = jet_rows(jet);
        const std::optional<PlaceBend> now = bend_of(rows, own), then = bend_of(rows, was);
        if (!now || !then) continue;
        // Places are emphasised where they were before, wherever the surface comes to lie.
        const Vector3d place = was.transpose() * jet.at;
        sums.add_place(*now, *then, own, was, before.least,
                       shares[i] * shares[j] * now->area * emphasis(before, place));
      }
    }
    energy.constant += sums.constant;
    for (Eigen::Index i = 0; i < sums.form.rows(); ++i) {
      const Eigen::Index row = 3 * which[i / 3] + i % 3;
      energy.gradient[row] += sums.gradient[i];
      if (!counts[which[i / 3]]) continue;
      for (Eigen::Index j = 0; j < sums.form.cols(); ++j) {
        if (!counts[which[j / 3]]) continue;
        // The lower half is what the sums have.
        entries.emplace_back(row, 3 * which[j / 3] + j % 3,
                             sums.form(std::max(i, j), std::min(i, j)));
      }
    }
  }
  energy.matrix.setFromTriplets(entries.begin(), entries.end());
  return energy;
}

}  // namespace hull::modelling

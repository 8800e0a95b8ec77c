// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/bend_sums.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <map>
#include <optional>

namespace hull::modelling {
namespace {

// Of the product of both derivatives: less is no area.
constexpr double kFlatPlace = 1e-9;

// The row of weights that gives the second derivative along a line of what a piece's points carry.
Eigen::RowVectorXd second_derivative(const surface::PieceWeights::Jet& jet,
                                     const std::vector<Vector3d>& points,
                                     const std::vector<int>& which, const Vector3d& along,
                                     bool is_cut) {
  Eigen::Matrix<double, 5, Eigen::Dynamic> rows(5, jet.ds.size());
  rows << jet.ds.transpose(), jet.dt.transpose(), jet.dss.transpose(), jet.dst.transpose(),
      jet.dtt.transpose();
  Eigen::Matrix<double, 5, 3> at = Eigen::Matrix<double, 5, 3>::Zero();
  for (std::size_t i = 0; i < which.size(); ++i) {
    at += rows.col(static_cast<Eigen::Index>(i)) * points[which[i]].transpose();
  }
  const Vector3d s = at.row(0), t = at.row(1);
  if (!(s.cross(t).norm() > kFlatPlace * s.norm() * t.norm())) {
    // A place without area has no part in the sum.
    return Eigen::RowVectorXd::Zero(rows.cols());
  }
  Eigen::Matrix2d metric;
  metric << s.dot(s), s.dot(t), s.dot(t), t.dot(t);
  const Eigen::Matrix2d inverse = metric.inverse();
  const auto parts = [&](const Vector3d& x) -> Eigen::Vector2d {
    return inverse * Eigen::Vector2d(x.dot(s), x.dot(t));
  };
  // In (s, t) per metre along the line.
  const Eigen::Vector2d d = parts(along);
  // The second derivative along d, by ss, st and tt.
  const auto twice = [&](const auto& of) {
    return (d[0] * d[0] * of.row(2) + 2.0 * d[0] * d[1] * of.row(3) + d[1] * d[1] * of.row(4))
        .eval();
  };
  const Vector3d bend = twice(at).transpose();
  // What only runs along the surface, or along the line itself, is no bend.
  const Eigen::Vector2d slides = is_cut ? parts(bend) : Eigen::Vector2d(bend.dot(along) * d);
  return twice(rows) - slides.transpose() * rows.topRows(2);
}

}  // namespace

BendSums::BendSums(const surface::LimitSurface& surface) : weights_(surface) {}

MoveCondition BendSums::of_sections(const std::vector<Vector3d>& points,
                                    const std::vector<BendPlace>& places) const {
  return sum(points, places, true);
}

MoveCondition BendSums::of_own_lines(const std::vector<Vector3d>& points,
                                     const std::vector<BendPlace>& places) const {
  return sum(points, places, false);
}

MoveCondition BendSums::sum(const std::vector<Vector3d>& points,
                            const std::vector<BendPlace>& places, bool is_cut) const {
  std::map<int, Vector3d> slopes;
  for (const BendPlace& place : places) {
    const std::optional<surface::PieceWeights::Place> found =
        weights_.find(place.cell, place.u, place.v);
    if (!found) continue;
    const std::vector<int>& which = weights_.piece(found->piece).points;
    const Eigen::RowVectorXd row =
        second_derivative(weights_.jet(*found), points, which, place.along, is_cut);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const auto [slope, is_new] = slopes.try_emplace(which[i], Vector3d::Zero());
      slope->second += row[static_cast<Eigen::Index>(i)] * place.out;
    }
  }
  // In the order of the points, whatever that of the places.
  MoveCondition condition;
  for (const auto& [point, slope] : slopes) {
    condition.points.push_back(point);
    condition.slopes.push_back(slope);
  }
  return condition;
}

}  // namespace hull::modelling

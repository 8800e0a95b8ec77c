// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_bounds.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "modelling/targets/bounded_dual.h"

namespace hull::modelling {
namespace {

// Of a bound's direction, within the space: shorter is none.
constexpr double kNoMove = 1e-9;

FitBound of_length_one(const FitBound& bound) {
  const double length = bound.direction.norm();
  return {bound.point, bound.direction / length, bound.least / length};
}

}  // namespace

MoveBounds::MoveBounds(const std::vector<FitBound>& bounds, const MoveSpace& space)
    : space_(space) {
  std::vector<MoveCondition> all, kept;
  for (const FitBound& bound : bounds) {
    all.push_back({{bound.point}, {of_length_one(bound).direction}});
  }
  const ConditionRows rows = condition_rows(all, space.point_count()) * space.basis();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    // No multiplier could meet such a row: the dual would be without bound.
    if (rows.row(static_cast<Eigen::Index>(i)).norm() <= kNoMove) continue;
    bounds_.push_back(of_length_one(bounds[i]));
    kept.push_back(all[i]);
  }
  rows_ = condition_rows(kept, space.point_count()) * space.basis();
}

Eigen::VectorXd MoveBounds::gaps(const std::vector<Vector3d>& points) const {
  Eigen::VectorXd gaps(static_cast<Eigen::Index>(bounds_.size()));
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const FitBound& bound = bounds_[i];
    gaps[static_cast<Eigen::Index>(i)] = bound.least - bound.direction.dot(points[bound.point]);
  }
  return gaps;
}

Eigen::VectorXd MoveBounds::least(Eigen::VectorXd free, const Eigen::VectorXd& gaps,
                                  const Solve& solve) const {
  Eigen::VectorXd y = free;
  std::vector<Eigen::Index> set;
  std::vector<char> counts(bounds_.size(), 0);
  Eigen::MatrixXd across(y.size(), 0);  // H⁻¹ rowsᵀ of the set
  while (true) {
    const Eigen::VectorXd missing = gaps - rows_ * y;
    const double rounding =
        kBoundRounding * std::max(y.lpNorm<Eigen::Infinity>(), gaps.lpNorm<Eigen::Infinity>());
    const auto known = static_cast<Eigen::Index>(set.size());
    for (Eigen::Index i = 0; i < missing.size(); ++i) {
      // What has joined never leaves the set, though its multiplier may be zero: so rounds are no
      // more than bounds. NaN joins nothing, and goes back to the caller.
      if (counts[i] || !(missing[i] > rounding)) continue;
      counts[i] = 1;
      set.push_back(i);
    }
    const auto count = static_cast<Eigen::Index>(set.size());
    if (count == known) return y;
    Eigen::MatrixXd rows(count, y.size());
    for (Eigen::Index k = 0; k < count; ++k) rows.row(k) = rows_.row(set[k]);
    // Only for those that joined: solving with H is what costs. Then rows · across is the Schur
    // complement rows H⁻¹ rowsᵀ, as small as the set.
    across.conservativeResize(Eigen::NoChange, count);
    across.rightCols(count - known) = solve(rows.bottomRows(count - known).transpose());
    // No upper bounds, and no price at which a bound may be broken.
    const Eigen::VectorXd none =
        Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
    y = free + across * bounded_dual(rows * across, rows * free, {gaps(set), none, none});
  }
}

std::optional<std::vector<Vector3d>> MoveBounds::moves_within(
    const std::vector<Vector3d>& points) const {
  if (bounds_.empty()) return std::nullopt;
  const Eigen::VectorXd missing = gaps(points);
  if (!(missing.maxCoeff() > 0.0)) return std::nullopt;
  // H is 1: as the basis is orthonormal, the shortest y is that of the shortest moves.
  const Eigen::VectorXd y = least(Eigen::VectorXd::Zero(space_.size()), missing,
                                  [](const Eigen::MatrixXd& right) { return right; });
  const Eigen::VectorXd moves = space_.basis() * y;
  std::vector<Vector3d> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.emplace_back(moves.segment<3>(3 * static_cast<Eigen::Index>(i)));
  }
  return found;
}

}  // namespace hull::modelling

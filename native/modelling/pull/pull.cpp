// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull/pull.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "mesh/dense_solvers.h"
#include "surface/pieces/point_weights.h"

namespace hull::modelling {
namespace {

// Singular values are those of weights that sum to 1: below this a direction counts as held.
constexpr double kLeastWeight = 1e-6;
// Of the pull: what is left where a target cannot be reached is never near this, and rounding is
// far below.
constexpr double kMiss = 1e-8;

void check_targets(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PullTarget& t = targets[i];
    const std::string name = "Target " + std::to_string(i);
    if (t.cell < 0 || t.cell >= surface.cell_count()) {
      throw std::invalid_argument(name + " is on cell " + std::to_string(t.cell) +
                                  ", but the cells are 0 to " +
                                  std::to_string(surface.cell_count() - 1) + ".");
    }
    if (!(t.u >= 0.0 && t.u <= 1.0 && t.v >= 0.0 && t.v <= 1.0)) {
      throw std::invalid_argument(name + ": u and v must be within [0, 1].");
    }
    if (!t.point.allFinite() || t.point.cwiseAbs().maxCoeff() > mesh::kMaxCoordinate) {
      throw std::invalid_argument(name + " is no place within 1e9 m.");
    }
  }
}

using Sparse = Eigen::SparseMatrix<double>;
using WeightsOfPlaces = std::vector<std::vector<surface::PointWeight>>;

// A column for each coordinate of all control points' moves, in threes of rows for each place.
Sparse weights_of(const WeightsOfPlaces& rows, Eigen::Index columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const surface::PointWeight& w : rows[i]) {
      for (int axis = 0; axis < 3; ++axis) {
        entries.emplace_back(3 * static_cast<Eigen::Index>(i) + axis, 3 * w.point + axis, w.weight);
      }
    }
  }
  Sparse weights(3 * static_cast<Eigen::Index>(rows.size()), columns);
  weights.setFromTriplets(entries.begin(), entries.end());
  return weights;
}

// A⁺ r, where singular values below kLeastWeight count as zero.
Eigen::VectorXd least_norm(const Eigen::MatrixXd& A, const Eigen::VectorXd& r) {
  if (A.cols() == 0) return Eigen::VectorXd::Zero(0);
  const mesh::SingularValues svd = mesh::singular_values(A);
  const auto solve = [&svd](const Eigen::VectorXd& b) {
    Eigen::VectorXd c = svd.u.transpose() * b;
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      const double s = svd.values[i];
      c[i] = s > kLeastWeight ? c[i] / s : 0.0;
    }
    return Eigen::VectorXd(svd.v * c);
  };
  Eigen::VectorXd x = solve(r);
  x += solve(r - A * x);  // takes away what the division by small values left
  return x;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

[[noreturn]] void throw_unreachable(std::size_t target, double left) {
  throw std::invalid_argument("Target " + std::to_string(target) + " cannot be reached, " +
                              number(left) +
                              " m are left: control points there are locked or held in planes, or "
                              "another target is in the way. Free some of them, or pull within "
                              "the plane.");
}

// Moves of all control points, and what is left of r.
struct Solution {
  Eigen::VectorXd moves, left;
};

// The shortest sum of `directions`, moves of all control points, that takes the places to r.
Solution least_moves(const Sparse& weights, const Sparse& directions, const Eigen::VectorXd& r) {
  const Sparse by_direction = weights * directions;
  std::vector<Eigen::Index> used;
  for (Eigen::Index k = 0; k < by_direction.cols(); ++k) {
    // Those that move no place are zero in the shortest sum, and would only make the matrix large.
    if (by_direction.col(k).nonZeros() > 0) used.push_back(k);
  }
  Eigen::MatrixXd A(r.size(), static_cast<Eigen::Index>(used.size()));
  for (std::size_t k = 0; k < used.size(); ++k) {
    A.col(static_cast<Eigen::Index>(k)) = by_direction.col(used[k]);
  }
  // The directions of a MoveSpace are orthonormal, so that the shortest x is that of the shortest
  // moves; with a radius there are no more directions than equations.
  const Eigen::VectorXd x = least_norm(A, r);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(directions.cols());
  all(used) = x;
  return {directions * all, r - A * x};
}

// What all control points do as each place moves along each axis, within the limits.
Sparse following_moves(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets,
                       const WeightsOfPlaces& rows, const ReshapeLimits& limits,
                       const PullSpread& spread, const MoveSpace& space) {
  const std::vector<Freedom> freedoms = freedoms_within(limits.limits, space.point_count());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vector3d place = surface.position(targets[i].cell, targets[i].u, targets[i].v);
    for (const auto& [point, follows] : following(surface, rows[i], place, freedoms, spread)) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          entries.emplace_back(3 * point + a, 3 * static_cast<Eigen::Index>(i) + b, follows(a, b));
        }
      }
    }
  }
  Sparse moves(space.basis().rows(), 3 * static_cast<Eigen::Index>(targets.size()));
  moves.setFromTriplets(entries.begin(), entries.end());
  // Each follows as it may alone; what ties and kept sums make of that is the projection into the
  // space.
  return space.basis() * (space.basis().transpose() * moves);
}

}  // namespace

Pull pull(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets,
          const ReshapeLimits& limits, const PullSpread& spread) {
  check_targets(surface, targets);
  check_spread(spread);
  surface::PointWeights weights(surface);
  WeightsOfPlaces rows;
  Eigen::VectorXd r(3 * static_cast<Eigen::Index>(targets.size()));
  double longest = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PullTarget& t = targets[i];
    rows.push_back(weights.at(t.cell, t.u, t.v));
    // The surface is linear in its points: this is what the moves are to add up to.
    const Vector3d pulled = t.point - surface.position(t.cell, t.u, t.v);
    r.segment<3>(3 * static_cast<Eigen::Index>(i)) = pulled;
    longest = std::max(longest, pulled.norm());
  }
  const MoveSpace space(limits, surface.mesh().topology().vertex_count());
  const Sparse places = weights_of(rows, space.basis().rows());
  const Solution solution =
      spread.radius > 0.0
          ? least_moves(places, following_moves(surface, targets, rows, limits, spread, space), r)
          : least_moves(places, space.basis(), r);

  Pull result{{}, {}, 0.0, 0.0};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double miss = solution.left.segment<3>(3 * static_cast<Eigen::Index>(i)).norm();
    // Of the longest pull: where places are pulled by very different ways the short one is met to
    // the rounding of the long one.
    if (miss > kMiss * longest) throw_unreachable(i, miss);
    result.miss = std::max(result.miss, miss);
  }
  for (int point = 0; point < space.point_count(); ++point) {
    const Vector3d move = solution.moves.segment<3>(3 * static_cast<Eigen::Index>(point));
    if (move.isZero(0.0)) continue;
    result.points.push_back(point);
    result.moves.push_back(move);
    if (longest > 0.0) result.reach = std::max(result.reach, move.norm() / longest);
  }
  return result;
}

}  // namespace hull::modelling

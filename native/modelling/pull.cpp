// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

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
      throw std::invalid_argument(name + " is no place within " + std::to_string(1e9) + " m.");
    }
  }
}

// What each of the control points with a weight may do; not those that may do nothing.
std::map<int, Freedom> with_weight(const std::vector<Freedom>& freedoms,
                                   const std::vector<std::vector<surface::PointWeight>>& rows) {
  std::map<int, Freedom> result;
  for (const auto& row : rows) {
    for (const surface::PointWeight& w : row) {
      if (freedoms[w.point].count > 0) result.try_emplace(w.point, freedoms[w.point]);
    }
  }
  return result;
}

// The columns of each point's freedom, then A.
struct LinearProblem {
  std::map<int, Freedom> freedoms;
  std::map<int, Eigen::Index> first_column;
  Eigen::MatrixXd A;

  LinearProblem(std::map<int, Freedom> of_points,
                const std::vector<std::vector<surface::PointWeight>>& rows)
      : freedoms(std::move(of_points)) {
    Eigen::Index columns = 0;
    for (const auto& [point, freedom] : freedoms) {
      first_column[point] = columns;
      columns += freedom.count;
    }
    A.setZero(3 * static_cast<Eigen::Index>(rows.size()), columns);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const surface::PointWeight& w : rows[i]) {
        const auto it = freedoms.find(w.point);
        if (it == freedoms.end()) continue;
        for (int k = 0; k < it->second.count; ++k) {
          A.block<3, 1>(3 * static_cast<Eigen::Index>(i), first_column[w.point] + k) =
              w.weight * it->second.directions[k];
        }
      }
    }
  }

  Vector3d move_of(int point, const Eigen::VectorXd& x) const {
    Vector3d move = Vector3d::Zero();
    const Freedom& freedom = freedoms.at(point);
    for (int k = 0; k < freedom.count; ++k) {
      move += x[first_column.at(point) + k] * freedom.directions[k];
    }
    return move;
  }
};

// A⁺ r, where singular values below kLeastWeight count as zero.
Eigen::VectorXd least_norm(const Eigen::MatrixXd& A, const Eigen::VectorXd& r) {
  if (A.cols() == 0) return Eigen::VectorXd::Zero(0);
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto solve = [&svd](const Eigen::VectorXd& b) {
    Eigen::VectorXd c = svd.matrixU().transpose() * b;
    for (Eigen::Index i = 0; i < c.size(); ++i) {
      const double s = svd.singularValues()[i];
      c[i] = s > kLeastWeight ? c[i] / s : 0.0;
    }
    return Eigen::VectorXd(svd.matrixV() * c);
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

// Moves by point, and what is left of r.
struct Solution {
  std::map<int, Vector3d> moves;
  Eigen::VectorXd left;
};

Solution least_moves(const std::map<int, Freedom>& freedoms,
                     const std::vector<std::vector<surface::PointWeight>>& rows,
                     const Eigen::VectorXd& r) {
  const LinearProblem problem(freedoms, rows);
  const Eigen::VectorXd x = least_norm(problem.A, r);
  Solution solution{{}, r - problem.A * x};
  for (const auto& [point, freedom] : problem.freedoms) {
    solution.moves[point] = problem.move_of(point, x);
  }
  return solution;
}

Solution spread_moves(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets,
                      const std::vector<std::vector<surface::PointWeight>>& rows,
                      const std::vector<Freedom>& freedoms, const PullSpread& spread,
                      const Eigen::VectorXd& r) {
  std::vector<Following> followings;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PullTarget& t = targets[i];
    followings.push_back(
        following(surface, rows[i], surface.position(t.cell, t.u, t.v), freedoms, spread));
  }
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(r.size(), r.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      for (const surface::PointWeight& w : rows[i]) {
        const auto it = followings[k].find(w.point);
        if (it == followings[k].end()) continue;
        A.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(k)) +=
            w.weight * it->second;
      }
    }
  }
  const Eigen::VectorXd x = least_norm(A, r);
  Solution solution{{}, r - A * x};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const auto& [point, follows] : followings[k]) {
      const auto [it, is_new] = solution.moves.try_emplace(point, Vector3d::Zero());
      it->second += follows * x.segment<3>(3 * static_cast<Eigen::Index>(k));
    }
  }
  return solution;
}

}  // namespace

Pull pull(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets,
          const MoveLimits& limits, const PullSpread& spread) {
  check_targets(surface, targets);
  check_spread(spread);
  surface::PointWeights weights(surface);
  std::vector<std::vector<surface::PointWeight>> rows;
  Eigen::VectorXd r(3 * static_cast<Eigen::Index>(targets.size()));
  double longest = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PullTarget& t = targets[i];
    rows.push_back(weights.at(t.cell, t.u, t.v));
    const Vector3d pulled = t.point - surface.position(t.cell, t.u, t.v);
    r.segment<3>(3 * static_cast<Eigen::Index>(i)) = pulled;
    longest = std::max(longest, pulled.norm());
  }
  const std::vector<Freedom> freedoms =
      freedoms_within(limits, surface.mesh().topology().vertex_count());
  const Solution solution = spread.radius > 0.0
                                ? spread_moves(surface, targets, rows, freedoms, spread, r)
                                : least_moves(with_weight(freedoms, rows), rows, r);

  Pull result{{}, {}, 0.0, 0.0};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const double miss = solution.left.segment<3>(3 * static_cast<Eigen::Index>(i)).norm();
    if (miss > kMiss * longest) throw_unreachable(i, miss);
    result.miss = std::max(result.miss, miss);
  }
  for (const auto& [point, move] : solution.moves) {
    if (move.isZero(0.0)) continue;
    result.points.push_back(point);
    result.moves.push_back(move);
    if (longest > 0.0) result.reach = std::max(result.reach, move.norm() / longest);
  }
  return result;
}

}  // namespace hull::modelling

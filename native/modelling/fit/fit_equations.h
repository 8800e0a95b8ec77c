// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "modelling/reshape/move_space.h"

namespace hull::modelling {

class MoveBounds;  // fit_bounds.h

// Normal equations of moves of control points: H x = g for the least ½ xᵀHx - gᵀx, sparse, by 3 x 3
// blocks of pairs of points.
class FitEquations {
 public:
  explicit FitEquations(int point_count)
      : gradient_(3 * static_cast<Eigen::Index>(point_count)), count_(point_count) {
    gradient_.setZero();
  }

  // Adds the terms of some points: hessian (3k x 3k), of which the lower half counts, and gradient.
  void add(const std::vector<int>& points, const Eigen::MatrixXd& hessian,
           const Eigen::VectorXd& gradient);
  // The same of a quadratic form (k x k) that is the same for x, y and z.
  void add_scalar(const std::vector<int>& points, const Eigen::MatrixXd& form,
                  const Eigen::Matrix<double, Eigen::Dynamic, 3>& gradient);

  // The same of a form of all points, symmetric.
  void add_scalar(const Eigen::SparseMatrix<double>& form,
                  const Eigen::Matrix<double, Eigen::Dynamic, 3>& gradient);

  // Moves of all points within the space, of (H + damping · m · 1) x = g in its basis, m the mean
  // of the diagonal. None where that is not positive definite to rounding.
  std::optional<std::vector<Vector3d>> solve(const MoveSpace& space, double damping) const;
  // The same within bounds, whose gaps are those of the points as they are.
  std::optional<std::vector<Vector3d>> solve(const MoveSpace& space, double damping,
                                             const MoveBounds& bounds,
                                             const Eigen::VectorXd& gaps) const;

 private:
  Eigen::Matrix3d& block(int row, int column) {
    const auto key = static_cast<std::uint64_t>(row) * count_ + column;
    const auto [it, is_new] = blocks_.try_emplace(key);
    if (is_new) it->second.setZero();
    return it->second;
  }

  Eigen::SparseMatrix<double> hessian() const;

  std::unordered_map<std::uint64_t, Eigen::Matrix3d> blocks_;  // row >= column
  Eigen::VectorXd gradient_;
  std::uint64_t count_;
};

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_equations.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <utility>

#include "modelling/fit/fit_bounds.h"

namespace hull::modelling {

void FitEquations::add(const std::vector<int>& points, const Eigen::MatrixXd& hessian,
                       const Eigen::VectorXd& gradient) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    gradient_.segment<3>(3 * static_cast<Eigen::Index>(points[i])) += gradient.segment<3>(row);
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (points[i] < points[j]) continue;
      const auto column = 3 * static_cast<Eigen::Index>(j);
      // Numbers of points need not rise: where they fall the block is the transpose of what the
      // lower half of `hessian` has.
      block(points[i], points[j]) += row >= column
                                         ? Eigen::Matrix3d(hessian.block<3, 3>(row, column))
                                         : hessian.block<3, 3>(column, row).transpose();
    }
  }
}

void FitEquations::add_scalar(const std::vector<int>& points, const Eigen::MatrixXd& form,
                              const Eigen::Matrix<double, Eigen::Dynamic, 3>& gradient) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    gradient_.segment<3>(3 * static_cast<Eigen::Index>(points[i])) += gradient.row(row).transpose();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (points[i] < points[j]) continue;
      block(points[i], points[j]).diagonal().array() += form(row, static_cast<Eigen::Index>(j));
    }
  }
}

Eigen::SparseMatrix<double> FitEquations::hessian() const {
  std::vector<Eigen::Triplet<double>> lower;
  lower.reserve(9 * blocks_.size());
  for (const auto& [key, values] : blocks_) {
    const auto row = static_cast<Eigen::Index>(3 * (key / count_)),
               column = static_cast<Eigen::Index>(3 * (key % count_));
    for (int a = 0; a < 3; ++a) {
      // A block on the diagonal is symmetric: its lower half is enough.
      for (int b = 0; b < (row == column ? a + 1 : 3); ++b) {
        // Each entry comes once: the order of the hash map has no say in any sum.
        lower.emplace_back(row + a, column + b, values(a, b));
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(gradient_.size(), gradient_.size());
  matrix.setFromTriplets(lower.begin(), lower.end());
  return matrix.selfadjointView<Eigen::Lower>();
}

void FitEquations::add_scalar(const Eigen::SparseMatrix<double>& form,
                              const Eigen::Matrix<double, Eigen::Dynamic, 3>& gradient) {
  for (int column = 0; column < form.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(form, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      if (row >= column) block(row, column).diagonal().array() += entry.value();
    }
  }
  for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
    gradient_.segment<3>(3 * k) += gradient.row(k).transpose();
  }
}

std::optional<std::vector<Vector3d>> FitEquations::solve(const MoveSpace& space,
                                                         double damping) const {
  return solve(space, damping, MoveBounds({}, space), {});
}

std::optional<std::vector<Vector3d>> FitEquations::solve(const MoveSpace& space, double damping,
                                                         const MoveBounds& bounds,
                                                         const Eigen::VectorXd& gaps) const {
  const Eigen::SparseMatrix<double>& basis = space.basis();
  std::vector<Vector3d> moves(count_, Vector3d::Zero());
  if (space.size() == 0) return moves;
  Eigen::SparseMatrix<double> matrix = basis.transpose() * (hessian() * basis);
  Eigen::SparseMatrix<double> unit(matrix.rows(), matrix.cols());
  unit.setIdentity();
  // By 1, not by the diagonal itself: a move that nothing tells of has a zero there, and is to stay
  // at 0 rather than make the matrix singular.
  matrix += damping * matrix.diagonal().sum() / static_cast<double>(matrix.rows()) * unit;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const auto solve = [&](const Eigen::MatrixXd& right) -> Eigen::MatrixXd {
    return factors.solve(right);
  };
  Eigen::VectorXd y = factors.solve(basis.transpose() * gradient_);
  if (!bounds.empty()) y = bounds.least(std::move(y), gaps, solve);
  const Eigen::VectorXd x = basis * y;
  if (!x.allFinite()) return std::nullopt;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i] = x.segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  return moves;
}

}  // namespace hull::modelling

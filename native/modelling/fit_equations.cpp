// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit_equations.h"

#include <Eigen/SparseCholesky>

namespace hull::modelling {

void FitEquations::add(const std::vector<int>& points, const Eigen::MatrixXd& hessian,
                       const Eigen::VectorXd& gradient) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    gradient_.segment<3>(3 * static_cast<Eigen::Index>(points[i])) += gradient.segment<3>(row);
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (points[i] < points[j]) continue;
      const auto column = 3 * static_cast<Eigen::Index>(j);
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

std::optional<std::vector<Vector3d>> FitEquations::solve(const std::vector<Freedom>& freedoms,
                                                         double damping) const {
  std::vector<Eigen::Index> first;
  Eigen::Index size = 0;
  for (const Freedom& freedom : freedoms) {
    first.push_back(size);
    size += freedom.count;
  }
  std::vector<Vector3d> moves(freedoms.size(), Vector3d::Zero());
  if (size == 0) return moves;
  std::vector<Eigen::Triplet<double>> entries;
  double trace = 0.0;
  for (const auto& [key, values] : blocks_) {
    const auto i = static_cast<std::size_t>(key / count_),
               j = static_cast<std::size_t>(key % count_);
    const Freedom &of_i = freedoms[i], &of_j = freedoms[j];
    for (int a = 0; a < of_i.count; ++a) {
      const Eigen::RowVector3d row = of_i.directions[a].transpose() * values;
      for (int b = 0; b < (i == j ? a + 1 : of_j.count); ++b) {
        const double value = row.dot(of_j.directions[b]);
        entries.emplace_back(first[i] + a, first[j] + b, value);
        if (i == j && a == b) trace += value;
      }
    }
  }
  const double add = damping * trace / static_cast<double>(size);
  for (Eigen::Index i = 0; i < size; ++i) entries.emplace_back(i, i, add);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd right(size);
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    for (int a = 0; a < freedoms[i].count; ++a) {
      right[first[i] + a] =
          freedoms[i].directions[a].dot(gradient_.segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
  }
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd x = factors.solve(right);
  if (!x.allFinite()) return std::nullopt;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    for (int a = 0; a < freedoms[i].count; ++a) {
      moves[i] += x[first[i] + a] * freedoms[i].directions[a];
    }
  }
  return moves;
}

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/dense_solvers.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace hull::mesh {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Orthogonal = Eigen::CompleteOrthogonalDecomposition<MatrixXd>;

}  // namespace

VectorXd least_norm_solution(const MatrixXd& A, const VectorXd& b, double threshold) {
  Orthogonal factors;
  if (threshold > 0.0) factors.setThreshold(threshold);
  return factors.compute(A).solve(b);
}

MatrixXd least_norm_solutions(const MatrixXd& A, const MatrixXd& B) {
  return Orthogonal(A).solve(B);
}

MatrixXd pseudo_inverse(const MatrixXd& A) { return Orthogonal(A).pseudoInverse(); }

SingularValues singular_values(const MatrixXd& A) {
  // Of small ones by Jacobi's rotations.
  const Eigen::BDCSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

bool are_independent(const MatrixXd& rows, double least) {
  if (rows.rows() == 0) return true;
  if (rows.rows() > rows.cols()) return false;
  const Eigen::ColPivHouseholderQR<MatrixXd> factors(rows.transpose());
  // With pivoting the diagonal falls: its last element is what is left of a row after all others.
  return factors.matrixR().diagonal().cwiseAbs().minCoeff() > least;
}

}  // namespace hull::mesh

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

// Eigen's decompositions of dense matrices of any size and rank, compiled once: wherever their
// templates are asked for they take ten to forty seconds.
namespace hull::mesh {

// x of the least norm among those with the least |A x - b|, by a complete orthogonal decomposition;
// of rank counts what is above `threshold` of the largest pivot (Eigen's own where it is 0).
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                    double threshold = 0.0);
// The same for each column of B.
Eigen::MatrixXd least_norm_solutions(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

// A⁺.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A);

// A = U diag(values) Vᵀ, thin; values fall.
struct SingularValues {
  Eigen::MatrixXd u;
  Eigen::VectorXd values;
  Eigen::MatrixXd v;
};
SingularValues singular_values(const Eigen::MatrixXd& A);

// Of rows of unit length: whether each has more than `least` left of what the others make up.
bool are_independent(const Eigen::MatrixXd& rows, double least);

}  // namespace hull::mesh

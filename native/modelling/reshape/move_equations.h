// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "modelling/reshape/move_space.h"

namespace hull::modelling {

// The equations basisᵀ · form · basis · y = right of moves within a space, factored; the form, over
// control points, is that of x, y and z alike.
//
// Where no limit mixes axes these are separate equations for x, y and z, and those with the same
// limits are factored once.
class MoveEquations {
 public:
  MoveEquations() = default;
  // Adds 1e-11 of the mean of the diagonal to it: where the form tells nothing of a point it stays.
  // Throws std::invalid_argument where the form is not positive definite then. REQUIRES: the space
  // is not empty.
  MoveEquations(const MoveSpace& space, const Eigen::SparseMatrix<double>& form);

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Factors = Eigen::SimplicialLLT<Matrix>;
  struct Part {
    std::vector<int> columns;  // of the basis
    std::shared_ptr<const Factors> factors;
  };

  std::vector<Part> parts_;
};

}  // namespace hull::modelling

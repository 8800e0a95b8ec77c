// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <functional>

namespace hull::modelling {

// The least of ½ xᵀ H x + gᵀ x under C x = d, where the length of x, √(xᵀ M x), is not more than a
// bound: x solves (H + p M) x = Cᵀ λ - g, with the one p >= 0 at which the length is the bound, or
// with p = 0 (as near as rounding lets come) where x is not that long. The length falls as p rises;
// p is found by Newton's method on its reciprocal (Moré and Sorensen 1983), which is nearly linear.
class BoundedMinimum {
 public:
  using Sparse = Eigen::SparseMatrix<double>;
  struct Result {
    Eigen::VectorXd x;
    double p, length;
    bool is_bound;  // the length, or what `excess` tells, bounds x
  };

  // M and C, for any number of H. Of M the diagonal is raised by 1e-11 of its mean.
  // Throws std::invalid_argument where M is not positive then, or rows of C depend on one another.
  BoundedMinimum(Sparse mass, const Sparse& conditions);

  // `excess` of x, if given: how many times too large something else about it is, 1 where it just
  // may be; with it p is raised until it is 1 or less. The length is met to 1e-12 of itself, the
  // excess to 1e-9; where conditions leave nothing within both it is the shortest x, which is
  // beyond them. REQUIRES: bound > 0; H positive semidefinite.
  Result solve(const Sparse& h, const Eigen::VectorXd& g, const Eigen::VectorXd& d, double bound,
               const std::function<double(const Eigen::VectorXd&)>& excess = {}) const;

  // The shortest x with C x = d.
  Eigen::VectorXd shortest(const Eigen::VectorXd& d) const;

 private:
  class System;

  Sparse mass_, conditions_;
};

}  // namespace hull::modelling

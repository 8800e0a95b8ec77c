// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hull::modelling {

// Least squares whose rows have entries in few columns beside one another, by Givens rotations row
// by row (Gentleman 1974; Dierckx 1993, 4.1.2): stable where normal equations are not, and as fast.
class BandedLeastSquares {
 public:
  // Rows have `band` entries; `sides` right sides are solved for at once.
  BandedLeastSquares(Eigen::Index unknowns, Eigen::Index band, Eigen::Index sides);

  // The row with `values`, not more than the band's, from column `first` on. REQUIRES: they fit.
  void add(Eigen::Index first, const Eigen::VectorXd& values, const Eigen::RowVectorXd& right);

  // unknowns x sides. What no row tells of is zero.
  Eigen::MatrixXd solve() const;

 private:
  Eigen::MatrixXd upper_;  // row i holds columns i, i + 1, … of the triangular matrix
  Eigen::MatrixXd right_;
};

}  // namespace hull::modelling

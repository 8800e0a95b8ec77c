// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/banded_least_squares.h"

#include <algorithm>
#include <cmath>

namespace hull::modelling {
namespace {

// Of the largest entry of the diagonal: less is rounding.
constexpr double kNothing = 1e-13;

}  // namespace

BandedLeastSquares::BandedLeastSquares(Eigen::Index unknowns, Eigen::Index band, Eigen::Index sides)
    : upper_(Eigen::MatrixXd::Zero(unknowns, band)),
      right_(Eigen::MatrixXd::Zero(unknowns, sides)) {}

void BandedLeastSquares::add(Eigen::Index first, const Eigen::VectorXd& values,
                             const Eigen::RowVectorXd& right) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(upper_.cols());
  row.head(values.size()) = values;
  Eigen::RowVectorXd rest = right;
  for (Eigen::Index i = first; i < upper_.rows(); ++i) {
    if (row.isZero(0.0)) return;
    if (row[0] != 0.0) {
      // The rotation that turns the new row's first entry into the one above it.
      const double length = std::hypot(upper_(i, 0), row[0]);
      const double c = upper_(i, 0) / length, s = row[0] / length;
      const Eigen::RowVectorXd above = upper_.row(i), side = right_.row(i);
      upper_.row(i) = c * above + s * row.transpose();
      right_.row(i) = c * side + s * rest;
      row = (c * row.transpose() - s * above).transpose().eval();
      rest = (c * rest - s * side).eval();
    }
    // The next row begins one column later.
    std::shift_left(row.data(), row.data() + row.size(), 1);
    row[row.size() - 1] = 0.0;
  }
}

Eigen::MatrixXd BandedLeastSquares::solve() const {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(right_.rows(), right_.cols());
  const double largest = upper_.col(0).cwiseAbs().maxCoeff();
  for (Eigen::Index i = upper_.rows() - 1; i >= 0; --i) {
    // No row tells of this one beyond what others do: it stays zero.
    if (!(std::abs(upper_(i, 0)) > kNothing * largest)) continue;
    Eigen::RowVectorXd rest = right_.row(i);
    const Eigen::Index count = std::min(upper_.cols(), upper_.rows() - i);
    for (Eigen::Index k = 1; k < count; ++k) rest -= upper_(i, k) * x.row(i + k);
    x.row(i) = rest / upper_(i, 0);
  }
  return x;
}

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/per_cell/uniform_fit.h"

#include <cassert>
#include <stdexcept>
#include <string>

#include "conversion/patches/bspline_patch.h"
#include "mesh/dense_solvers.h"

namespace hull::conversion {

UniformFit::UniformFit(int control_points, int intervals) {
  if (control_points < 4) {
    throw std::invalid_argument("a cubic patch needs at least 4 control points a side, not " +
                                std::to_string(control_points));
  }
  if (intervals < control_points) {
    throw std::invalid_argument(std::to_string(intervals) + " data intervals are too few for " +
                                std::to_string(control_points) + " control points");
  }
  const std::vector<double> knots = open_uniform_knots(3, control_points);
  basis_.setZero(intervals + 1, control_points);
  for (int i = 0; i <= intervals; ++i) {
    const BasisValues values = basis_values(knots, 3, static_cast<double>(i) / intervals);
    basis_.block(i, values.first, 1, 4) = values.rows.row(0);
  }
  // The first and last point are given, and only data between count.
  const Eigen::MatrixXd inner = basis_.block(1, 1, intervals - 1, control_points - 2);
  solver_ = mesh::pseudo_inverse(inner);
}

std::vector<Vector3d> UniformFit::curve(const std::vector<Vector3d>& data) const {
  assert(static_cast<int>(data.size()) == intervals() + 1);
  const Vector3d first = data.front(), last = data.back();
  Eigen::MatrixX3d rest(intervals() - 1, 3);
  for (int i = 1; i < intervals(); ++i) {
    rest.row(i - 1) = data[i] - basis_(i, 0) * first - basis_(i, control_points() - 1) * last;
  }
  const Eigen::MatrixX3d inner = solver_ * rest;
  std::vector<Vector3d> points{first};
  for (int i = 0; i < inner.rows(); ++i) points.push_back(inner.row(i).transpose());
  points.push_back(last);
  return points;
}

void UniformFit::interior(const std::vector<Vector3d>& data, std::vector<Vector3d>& points) const {
  const int n = control_points(), m = intervals();
  assert(static_cast<int>(data.size()) == (m + 1) * (m + 1));
  assert(static_cast<int>(points.size()) == n * n);
  const auto inner_rows = basis_.middleRows(1, m - 1);
  // The unknowns are a tensor product, so the least-squares operator is one too: apply the curve's
  // along u, then along v, to what the border leaves over. One coordinate at a time.
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd border(n, n), rest(m - 1, m - 1);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) border(i, j) = points[i * n + j](axis);
    }
    // What the given border alone makes of the patch is taken off the data.
    border.block(1, 1, n - 2, n - 2).setZero();
    for (int i = 1; i < m; ++i) {
      for (int j = 1; j < m; ++j) rest(i - 1, j - 1) = data[i * (m + 1) + j](axis);
    }
    rest -= inner_rows * border * inner_rows.transpose();
    const Eigen::MatrixXd inner = solver_ * rest * solver_.transpose();
    for (int i = 1; i < n - 1; ++i) {
      for (int j = 1; j < n - 1; ++j) points[i * n + j](axis) = inner(i - 1, j - 1);
    }
  }
}

}  // namespace hull::conversion

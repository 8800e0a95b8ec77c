// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/vectors.h"

namespace hull::conversion {

// Least-squares fit of cubic open-uniform B-splines to data on a uniform parameter grid, borders
// fixed (Greshake 2021, section 7.2). The operators depend on the two counts only: they are
// factored once here and then applied to any number of curves and patches.
//
// Exact to rounding for data that come from a cubic polynomial, or from any spline of the same
// knots.
class UniformFit {
 public:
  // Throws std::invalid_argument unless control_points >= 4 (cubic) and intervals >= control_points
  // (fewer data leave the least-squares problem undetermined).
  UniformFit(int control_points, int intervals);

  int control_points() const { return static_cast<int>(basis_.cols()); }
  int intervals() const { return static_cast<int>(basis_.rows()) - 1; }

  // The control points of a curve: data at i / intervals, i = 0 ... intervals. The ends are the
  // first and last datum, bit for bit; the others minimise the sum of the squared distances.
  // REQUIRES: data.size() == intervals + 1.
  std::vector<Vector3d> curve(const std::vector<Vector3d>& data) const;

  // Fills in the interior control points of a patch whose border control points are given and stay
  // as they are. Only data off the border are used: no interior control point moves the border.
  // Index of data: i * (intervals + 1) + j; of points: i * control_points + j. REQUIRES: sizes to
  // match.
  void interior(const std::vector<Vector3d>& data, std::vector<Vector3d>& points) const;

 private:
  Eigen::MatrixXd basis_;  // (intervals + 1, control_points): functions at the data
  Eigen::MatrixXd
      solver_;  // (control_points - 2, intervals - 1): data off the ends to control points
};

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hull::analysis {

// Derivatives of a number by the control points of a surface, a row each: by x, y and z.
using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// Derivatives of several numbers by some points, a row each: three columns a number.
using PointColumns = Eigen::MatrixXd;

}  // namespace hull::analysis

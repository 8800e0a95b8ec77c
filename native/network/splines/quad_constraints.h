// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "network/splines/quad_fit.h"

namespace hull::network {

// The inverse of a quadratic form over a patch's inner control points, (count_u - 2) x (count_v -
// 2), the same for all three coordinates: what it makes of a right hand side.
using InverseForm = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

// Moves inner control points by the least, in the sense of the form, such that the derivative
// across each side is at right angles to the side's normals at its inner knots. Where that takes
// moves of more than a tenth of the patch's size the normals contradict one another: then nothing
// is moved, and the answer is false.
bool meet_normals(conversion::BSplinePatch& patch, const std::array<QuadSide, 4>& sides,
                  const InverseForm& inverse);

}  // namespace hull::network

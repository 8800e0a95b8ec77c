// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "network/splines/quad_fit.h"

namespace hull::network {

// What a patch's derivative across a side is to be at right angles to, at a knot of the side: of
// control points, by their numbers, a sum with weights.
struct NormalConstraint {
  std::vector<std::pair<int, double>> weights;
  Vector3d normal;

  double excess(const conversion::BSplinePatch& patch) const;
};

// At the inner knots of all sides at which they have normals.
std::vector<NormalConstraint> normal_constraints(const conversion::BSplinePatch& patch,
                                                 const std::array<QuadSide, 4>& sides);

// The number of a control point among the inner ones, rows along v; -1 on the border.
int inner_number(const conversion::BSplinePatch& patch, int point);

// The inverse of a quadratic form over a patch's inner control points, (count_u - 2) x (count_v -
// 2), the same for all three coordinates: what it makes of a right hand side.
using InverseForm = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

// Moves inner control points by the least, in the sense of the form, such that the constraints
// hold. Where that takes moves of more than a tenth of the patch's size the normals contradict one
// another: then nothing is moved, and the answer is false.
bool meet_normals(conversion::BSplinePatch& patch, const std::array<QuadSide, 4>& sides,
                  const InverseForm& inverse);

}  // namespace hull::network

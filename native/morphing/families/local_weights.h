// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modelling/fields/shape_fields.h"
#include "morphing/families/hull_family.h"

namespace hull::morphing {

// Weights that hold around the base of a shape field, and fade with its intensity into those of the
// whole hull: the bow of one parent, the stern of another. Shift and change of the field count for
// nothing; one that protects keeps the weights of the whole hull, and needs none.
struct LocalWeights {
  modelling::ShapeField field;
  std::vector<double> weights;  // of each parent; they sum to 1
};

// Weights of each control point, points x parents, for HullFamily::points(). Fields are in the
// space of the first parent, and each point has the intensities at its limit point there: weights
// do not depend on the member. Where intensities are 1 all over the control points of a region its
// surface is the sum of the parents' with the local weights; on the way between, members are
// surfaces as smooth as any, whose weights are those of control points, not of surface points.
//
// `mirrored`: fields work on both sides of the centre plane. Throws std::invalid_argument as
// HullFamily::check_weights() does, and for fields without base.
Eigen::MatrixXd local_weights(const HullFamily& family, const std::vector<double>& weights,
                              const std::vector<LocalWeights>& local, bool mirrored);

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "production/models/closed_model.h"

namespace hull::production {

// Both parts of a model; one without triangles where all of it is on the other side.
struct CutModel {
  ClosedModel below, above;
};

// Cut in the plane in which coordinate `axis` (0, 1, 2) is `at`, both parts closed by what the
// plane has of the model. Points of the cut are exactly in the plane, and the same in both parts,
// so that their volumes sum to that of the model but for rounding. Triangles in the plane are made
// anew.
//
// Throws std::invalid_argument for a plane that is none, and where the model touches itself in the
// plane, so that a part would have sides of more than two triangles.
CutModel cut(const ClosedModel& model, int axis, double at);

// Round holes with an axis along `axis` in the model's faces in the plane `at`, which face to its
// upper (`upward`) or lower side, as polygons of `corners` corners on the circle: `centres` by the
// coordinates (axis + 1) % 3 and (axis + 2) % 3.
//
// REQUIRES: holes are within these faces and the model, and apart from one another.
ClosedModel drilled(const ClosedModel& model, int axis, double at, bool upward,
                    const std::vector<Eigen::Vector2d>& centres, double radius, double depth,
                    int corners);

}  // namespace hull::production

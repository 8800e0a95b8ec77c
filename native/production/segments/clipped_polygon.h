// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vectors.h"

namespace hull::production {

// What of a convex polygon is above a plane across an axis, or below it where `sign` is -1: convex
// too, corners in the plane included.
std::vector<Vector3d> clipped(const std::vector<Vector3d>& polygon, int axis, double at,
                              double sign);

}  // namespace hull::production

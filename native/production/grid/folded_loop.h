// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::production {

// Lines across a closed loop of points that folds onto itself in the plane y = `plane`, as the edge
// of a symmetric boat's deck and transom: from the side y > plane to the other one, where both have
// come equally far along the fold, one after another, so that between two of them lies one side
// of the loop on one of its sides or on both. At a point in the plane a line has no length.
//
// Throws std::invalid_argument if the loop has not just one part on each side of the plane.
std::vector<std::array<int, 2>> lines_across(const std::vector<Vector3d>& points,
                                             const std::vector<int>& loop, double plane);

}  // namespace hull::production

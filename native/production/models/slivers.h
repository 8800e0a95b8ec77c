// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::production {

// Triangles without a height to speak of, as of points on one line, are done away with where that
// can be: such a triangle and the one beyond its longest side become two others, on the other
// diagonal. What they cover stays the same but for their height, and so do the outer sides of all
// triangles. Others would touch what is beyond them along that side in points that are not theirs.
// `height`: over the longest side, what is none to speak of; what is no plane changes by that.
void flip_slivers(const std::vector<Vector3d>& points, std::vector<std::array<int, 3>>& triangles,
                  double height);

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::analysis {

// The centroid of a border loop's curve, by the lengths of its spans' control polygons; `spans`:
// their Bézier points. REQUIRES: there are any.
Vector3d border_centroid(const std::vector<std::array<Vector3d, 4>>& spans);

}  // namespace hull::analysis

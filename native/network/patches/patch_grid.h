// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "network/patches/ribboned_side.h"

namespace hull::network {

// Places of a patch's domain, and triangles between them, counterclockwise: rows of the square, or
// rings of a polygon around its centre. On each side there are the places of i / count.
struct PatchGrid {
  std::vector<Vector2d> places;
  std::vector<std::array<int, 3>> triangles;
};

// Throws std::invalid_argument for a count below one.
PatchGrid patch_grid(const std::vector<Vector2d>& domain, int count);

}  // namespace hull::network

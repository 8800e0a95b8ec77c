// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull::analysis {

// Which connected part of the surface (hull, rudder, demi-hull) something belongs to.
struct Bodies {
  std::vector<int> first_cell;                   // of each part, in the order of cells
  std::vector<int> of_cell, of_leaf, of_corner;  // the latter as numbered by SurfaceLayout
};

Bodies bodies_of(const surface::LimitSurface& surface);

}  // namespace hull::analysis

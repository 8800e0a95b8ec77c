// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit_rows.h"
#include "surface/limit_surface.h"
#include "surface/queries/surface_tree.h"

namespace hull::modelling::fit_internal {

// What places all over the surface want to lie on a shape.
struct PlacePulls {
  std::vector<FitRow> rows;  // weights are areas, and sum to 1
  double mean_square = 0.0;
};

// Places at thirds of each cell, to the tangent plane at the shape's nearest point; where that is
// on a border or an edge, to the point itself. Without them a part of the surface that no target is
// nearest to lies where it likes.
PlacePulls find_place_pulls(const surface::LimitSurface& surface,
                            const surface::LimitSurface& shape, const surface::SurfaceTree& tree);

}  // namespace hull::modelling::fit_internal

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/plane_cut.h"
#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"

namespace hull::morphing {

// Where a half hull is square to the centre plane (square_ties()), and the other one is so, too,
// where the layout with the hull's control points lies near it: points tied to the neighbours in
// the plane that they stay square to.
std::vector<modelling::TiedPoint> common_squares(const surface::LimitSurface& hull,
                                                 const surface::LimitSurface& layout,
                                                 const surface::LimitSurface& other);

// Control points of a flat region of a hull that come to lie in a flat of another one.
struct CommonFlat {
  std::vector<int> points;
  analysis::Plane plane;  // of the other hull
};

// Flat regions of a hull (within kInPlane) with the points that the layout brings near a flat
// region of the other hull, turned by less than kTurned; those with three points or more.
std::vector<CommonFlat> common_flats(const surface::LimitSurface& hull,
                                     const surface::LimitSurface& layout,
                                     const surface::LimitSurface& other);
inline constexpr double kTurned = 0.2;  // rad

}  // namespace hull::morphing

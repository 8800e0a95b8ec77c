// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// What keeps a half hull's surface square to the centre plane, where it is so, beside border points
// that square_ties() leaves out: those of one, three or more faces, of other faces than
// quadrilaterals, and corners. Sums that are to stay zero besides these ties.
//
// The surface is square to y = 0 at a place of its border where it has a direction a along y, in
// which x and z do not change. By the directions a of now that is linear in the control points:
// moves keep it where the derivatives of their x and z in direction a are zero. The places are so
// many on each bicubic piece of the border that all of it follows; beside irregular knots the moves
// of the few points that matter are nearly those of an affine map, along the plane, then.
//
// REQUIRES of the caller: points in the plane are held in it.
std::vector<MoveCondition> square_sums(const surface::LimitSurface& surface,
                                       const std::vector<TiedPoint>& ties);

}  // namespace hull::modelling

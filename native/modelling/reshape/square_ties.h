// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// What keeps a half hull's surface square to the centre plane where it is so: without it a smooth
// keel gets a knuckle when the surface is reshaped.
//
// Along a border the derivative across it is, whatever the valences of the points beside, the
// B-spline of the differences between these and the border's own. Where a border point has two
// quadrilaterals its one neighbour off the border is tied to it in x and z, if it is as far ahead
// and as high. REQUIRES of the caller: points in the plane are held in it.
//
// Border points of other numbers of faces are not tied: no single neighbour decides there, but
// square_sums().
std::vector<TiedPoint> square_ties(const surface::LimitSurface& surface);

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/exact/square_fan.h"

namespace hull::conversion {

// Moves the points of the nets that may be chosen, within the corner squares and so that neighbours
// keep the same border curves, until the angles between normals at the smooth seams are least:
// least squares over samples (Levenberg-Marquardt), moves kept small, the less so the longer the
// angle stays above `enough` (radians). Sides on creases stay. Leaves the fan as it is where
// nothing is gained. Returns seam_angle() afterwards.
//
// `normal_stiffness`: what moves along the normal weigh more than the others, for they are what
// takes the squares off the surface.
double fit_seams(SquareFan& fan, double enough, double normal_stiffness);

}  // namespace hull::conversion

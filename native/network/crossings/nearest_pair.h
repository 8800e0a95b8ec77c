// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "network/curves/nurbs_curve.h"

namespace hull::network {

// From parameters of two curves downhill to where their points are nearest to one another: a
// minimum of half the squared distance between the curves' ends, by Newton's method with bounds.
// Where the curves cross at an angle the place is exact to rounding; where they touch, as exact as
// the touch tells it: to the root of the rounding.
std::array<double, 2> nearest_pair(const NurbsCurve& first, const NurbsCurve& second,
                                   std::array<double, 2> start);

}  // namespace hull::network

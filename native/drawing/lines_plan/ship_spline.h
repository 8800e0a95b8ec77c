// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic B-splines in ship axes: parts of them.
#pragma once

#include <vector>

#include "surface/creases/cubic_spline.h"

namespace hull::drawing {

// The same curve between the parameters `from` and `to`, ending in its first and last control
// point (four equal knots at each end). REQUIRES: spline.begin() <= from < to <= spline.end().
surface::CubicSpline part_of_spline(const surface::CubicSpline& spline, double from, double to);

// The parameters, rising, at which the coordinate `axis` passes through `limit`, changing its side.
std::vector<double> crossings_of_spline(const surface::CubicSpline& spline, int axis, double limit);

}  // namespace hull::drawing

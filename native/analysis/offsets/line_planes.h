// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/sections.h"

namespace hull::analysis {

// The plane in which a line of the hull is cut that is to be drawn at `position`. At the hull's
// ends, its bottom and its greatest breadth it is kSamePosition of the size inside, which no one
// sees: a flat end, bottom or side then shows its edge, smoothly. Elsewhere it is exact.
Plane line_plane(const surface::LimitSurface& surface, Axis axis, double position);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/sections.h"

namespace hull::analysis {

// Of the mesh's size: positions nearer than this are the same.
inline constexpr double kSamePosition = 1e-6;
// And what is nearer to a plane lies in it, as points do that come from a file in single precision.
inline constexpr double kInPlane = 1e-7;

// The plane in which a line of the hull is cut that is to be drawn at `position`. At the hull's
// ends, its bottom and its greatest breadth it is kSamePosition inside, which no one sees: a flat
// end, bottom or side then shows its edge, smoothly. Elsewhere it is exact.
Plane line_plane(const surface::LimitSurface& surface, Axis axis, double position);

}  // namespace hull::analysis

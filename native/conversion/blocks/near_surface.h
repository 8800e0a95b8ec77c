// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/blocks/near_point.h"

namespace hull::conversion {

// A point of the surface near to `point`, found by near_point() from a place close by, and by the
// same in neighbouring cells while the nearest lies on the border of a cell. Its distance is an
// upper bound of that to the surface.
NearPoint near_surface(const RingedSurface& surface, const Vector3d& point, const CellPoint& start,
                       double enough);

}  // namespace hull::conversion

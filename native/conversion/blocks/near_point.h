// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/blocks/ringed_surface.h"

namespace hull::conversion {

struct CellPoint {
  int cell = -1;
  double u = 0.0, v = 0.0;
};

struct NearPoint {
  CellPoint place;
  double distance = 0.0;  // metres
};

// A point of a cell near to `point`, found from a place close by: no farther than that one, and in
// general the closest of the cell, so that its distance is an upper bound of that to the surface.
// The search ends where the distance is below `enough`.
NearPoint near_point(const RingedSurface& surface, const Vector3d& point, const CellPoint& start,
                     double enough);

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stations/station_cutter.h"

namespace hull {

// The underwater profile: the part of the centre plane y = 0 that is inside the body and below the
// water; openings are closed athwartships, so that their borders' projections bound it.
//
// It is the area of the immersed body's projection on the centre plane as well, unless part of the
// body hangs lower or reaches further than the body does amidships; of bodies beside the centre
// plane, as of a catamaran, it is zero.
struct ProfileArea {
  double area = 0.0;                   // m²
  Vector3d centre = Vector3d::Zero();  // m, y = 0; zero without an area
};

ProfileArea profile_area(const StationCutter& cutter, const Plane& water);

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stations/station_cutter.h"

namespace hull::analysis {

// The underwater profile: the part of the centre plane y = 0 that is inside the body and below the
// water; openings are closed athwartships, so that their borders' projections bound it. Of a body
// beside the centre plane, as a demi-hull or one of two rudders, it is the same of the plane amidst
// it. Those of several bodies add up, also where one hides another; but one that is mirrored counts
// once.
//
// It is the area of the immersed body's projection on the centre plane as well, unless part of the
// body hangs lower or reaches further than the body does in that plane.
struct ProfileArea {
  double area = 0.0;                   // m²
  Vector3d centre = Vector3d::Zero();  // m, y = 0; zero without an area
};

ProfileArea profile_area(const StationCutter& cutter, const Plane& water);

}  // namespace hull::analysis

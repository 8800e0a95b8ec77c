// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stations/profile_area.h"

namespace hull::analysis {

// The ship's profile on the centre plane in some water, openings closed athwartships, so that it
// ends where the modelled hull does: at the deck edge or on top of bulwarks. How bodies add up and
// what is hidden: profile_area.h.
struct LateralProfile {
  ProfileArea above;  // the water
  ProfileArea below;
};

LateralProfile lateral_profile(const StationCutter& cutter, const Plane& water);
LateralProfile lateral_profile(const HullBody& body, const Plane& water);

}  // namespace hull::analysis

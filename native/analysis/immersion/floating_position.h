// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// How a ship lies in the water. Angles in rad, below 90° of trim; any heel.
struct FloatingPosition {
  double draft = 0.0;  // m: z where the ship's own vertical through (draft_at, 0) meets the water
  double trim = 0.0;   // positive by the stern: the bow is up
  double heel = 0.0;   // positive to starboard: the side y < 0 is down
  double draft_at = 0.0;  // m: x where the draft is measured; that of midship for the mean draft
};

// In the ship's axes: the unit vector that points up, and the horizontal ones that point forward
// and, square to it, to starboard.
Vector3d up_direction(double trim, double heel);
Vector3d forward_direction(double trim, double heel);
Vector3d starboard_direction(double trim, double heel);

// The water's surface in the ship's axes; below it is the water. At 90° of heel the water is the
// centre plane whatever the draft.
Plane water_plane(const FloatingPosition& position);

// The draft at x = draft_at of a ship in the given water; infinite or not a number where the ship's
// vertical does not meet it, at 90° of heel.
double draft_in(const Plane& water, double draft_at);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/sea_water.h"
#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// What a body carries, its own weight included.
struct LoadCase {
  double mass_t = 0.0;                            // t
  Vector3d centre_of_gravity = Vector3d::Zero();  // m, in the ship's axes
  double water_density = kSeaWaterDensity;        // t/m³

  // The volume it has to displace, m³. Throws std::invalid_argument unless mass and density are
  // positive and all is finite.
  double displaced_volume() const;
};

}  // namespace hull::analysis

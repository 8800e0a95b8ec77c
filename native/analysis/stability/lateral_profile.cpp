// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/lateral_profile.h"

#include "analysis/stability/water_at_volume.h"

namespace hull::analysis {

LateralProfile lateral_profile(const HullBody& body, const Plane& water) {
  const StationCutter cutter(body);
  const HeightRange range = height_range(body, water.normal);
  const double above_all = range.high + 0.01 * (range.high - range.low);
  LateralProfile profile;
  profile.below = profile_area(cutter, water);
  // Wholly under water the profile is whole: what is above is the rest of it.
  const ProfileArea whole = profile_area(cutter, {water.normal, above_all});
  profile.above.area = whole.area - profile.below.area;
  if (profile.above.area > 0.0) {
    const Vector3d moment = whole.area * whole.centre - profile.below.area * profile.below.centre;
    profile.above.centre = moment / profile.above.area;
  }
  return profile;
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/lateral_profile.h"

#include <algorithm>

#include "analysis/appendages/profile_union.h"
#include "analysis/immersion/hull_heights.h"

namespace hull::analysis {
namespace {

// Of the whole profile: rounding leaves as much of a ship that is wholly under water.
constexpr double kNoArea = 1e-12;

// A height above all of the ship.
double above_all(const HullBody& body, const Vector3d& up) {
  HeightRange range = height_range(body, up);
  if (const std::vector<ProfilePart>* parts = body.joined_profile()) {
    for (const ProfilePart& part : *parts) {
      for (int side = 0; side < 2; ++side) {
        range.high = std::max(range.high, up.dot(Vector3d(part.x[side], 0.0, part.high[side])));
      }
    }
  }
  return range.high + 0.01 * (range.high - range.low);
}

}  // namespace

LateralProfile lateral_profile(const StationCutter& cutter, const Plane& water) {
  LateralProfile profile;
  profile.below = profile_area(cutter, water);
  // Wholly under water the profile is whole: what is above is the rest of it.
  const double above = above_all(cutter.body(), water.normal);
  const ProfileArea whole = profile_area(cutter, {water.normal, above});
  const double area = whole.area - profile.below.area;
  if (!(area > kNoArea * whole.area)) return profile;
  profile.above.area = area;
  const Vector3d moment = whole.area * whole.centre - profile.below.area * profile.below.centre;
  profile.above.centre = moment / area;
  return profile;
}

LateralProfile lateral_profile(const HullBody& body, const Plane& water) {
  return lateral_profile(StationCutter(body), water);
}

}  // namespace hull::analysis

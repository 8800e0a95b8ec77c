// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/floating_position.h"

#include <Eigen/Geometry>
#include <cmath>

namespace hull::analysis {

// The vertical as the ship sees it: turned by the trim in her centre plane, then by the heel about
// her own x axis.
Vector3d up_direction(double trim, double heel) {
  return {std::sin(trim), std::sin(heel) * std::cos(trim), std::cos(heel) * std::cos(trim)};
}

// What is left of the x axis in the horizontal plane; it does not vanish below 90° of trim.
Vector3d forward_direction(double trim, double heel) {
  return {std::cos(trim), -std::sin(heel) * std::sin(trim), -std::cos(heel) * std::sin(trim)};
}

Vector3d starboard_direction(double trim, double heel) {
  return forward_direction(trim, heel).cross(up_direction(trim, heel));
}

Plane water_plane(const FloatingPosition& position) {
  const Vector3d up = up_direction(position.trim, position.heel);
  // Through the point (draft_at, 0, draft).
  return {up, up.x() * position.draft_at + up.z() * position.draft};
}

double draft_in(const Plane& water, double draft_at) {
  return (water.offset - water.normal.x() * draft_at) / water.normal.z();
}

}  // namespace hull::analysis

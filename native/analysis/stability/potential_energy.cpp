// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/potential_energy.h"

#include <cmath>

#include "analysis/immersion/floating_position.h"

namespace hull::analysis {

double potential_energy(const Immersion& immersion, double volume,
                        const Vector3d& centre_of_gravity) {
  const Vector3d& n = immersion.water.normal;
  const double c = immersion.water.offset;
  // Both heights from the water's surface: offsets of a far origin cancel.
  return volume * (n.dot(centre_of_gravity) - c) -
         immersion.volume * (n.dot(immersion.centre_of_buoyancy) - c);
}

NormalDirections normal_directions(double trim, double heel, FreeRotations free) {
  const Vector3d up = up_direction(trim, heel);
  NormalDirections d;
  d.columns.resize(3, free.trim + free.heel);
  // On great circles of the unit sphere of normals d²n points to its centre.
  d.curvature = up;
  if (free.trim) d.columns.col(0) = forward_direction(trim, heel);
  if (free.heel && free.trim) d.columns.col(1) = -starboard_direction(trim, heel);
  if (free.heel && !free.trim) {
    // Heel about the ship's own axis: the normal runs on a small circle, whose centre is on the x
    // axis, not the sphere's.
    d.columns.col(0) = Vector3d(0.0, up.z(), -up.y());
    d.curvature.x() = 0.0;
  }
  return d;
}

Vector3d rotation_centre(const Immersion& immersion, const Vector3d& centre_of_gravity) {
  // Rounding leaves some area to a body that is wholly under water.
  constexpr double kNone = 1e-10;
  const double length = std::cbrt(immersion.volume);
  if (immersion.waterplane_area > kNone * length * length) return immersion.centre_of_flotation;
  return centre_of_gravity - immersion.water.height(centre_of_gravity) * immersion.water.normal;
}

Vector3d rotation_moment(const Immersion& immersion, const Vector3d& point, double volume,
                         const Vector3d& centre_of_gravity) {
  // Arms from F, not from the origin: far from F two large numbers would cancel.
  return volume * (centre_of_gravity - point) -
         immersion.volume * (immersion.centre_of_buoyancy - point);
}

Eigen::MatrixXd rotation_stiffness(const NormalDirections& directions, const Immersion& immersion,
                                   const Vector3d& moment) {
  const auto n = directions.columns.cols();
  return directions.columns.transpose() * immersion.waterplane_second * directions.columns -
         directions.curvature.dot(moment) * Eigen::MatrixXd::Identity(n, n);
}

}  // namespace hull::analysis

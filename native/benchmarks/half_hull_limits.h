// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modelling/reshape/reshape.h"
#include "modelling/reshape/square_sums.h"
#include "modelling/reshape/square_ties.h"

namespace hull::benchmarks {

// The limits that tools give a half hull: points in the centre plane held in it, and the surface
// square to it where it is.
inline modelling::ReshapeLimits half_hull_limits(const surface::LimitSurface& hull) {
  modelling::ReshapeLimits limits;
  limits.tied = modelling::square_ties(hull);
  limits.kept = modelling::square_sums(hull, limits.tied);
  const std::vector<Vector3d>& points = hull.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].y() != 0.0) continue;
    limits.limits.held.push_back({static_cast<int>(i), Vector3d::UnitY()});
  }
  return limits;
}

}  // namespace hull::benchmarks

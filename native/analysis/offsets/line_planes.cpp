// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/line_planes.h"

#include <algorithm>
#include <cmath>

#include "mesh/tolerances.h"

namespace hull::analysis {

Plane line_plane(const surface::LimitSurface& surface, Axis axis, double position) {
  const int coordinate = static_cast<int>(axis);
  const auto& points = surface.mesh().points();
  // Where the hull is flat at its end, its control points end there, too.
  double low = points.front()[coordinate], high = low;
  for (const Vector3d& point : points) {
    low = std::min(low, point[coordinate]);
    high = std::max(high, point[coordinate]);
  }
  const double step = kSamePosition * surface.mesh().size();
  if (std::abs(position - low) <= step) return plane_across(axis, low + step);
  if (std::abs(position - high) <= step) return plane_across(axis, high - step);
  return plane_across(axis, position);
}

}  // namespace hull::analysis

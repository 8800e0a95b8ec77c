// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/line_planes.h"

#include <cmath>

#include "mesh/tolerances.h"

namespace hull::analysis {

Plane line_plane(const surface::LimitSurface& surface, Axis axis, double position) {
  const int coordinate = static_cast<int>(axis);
  // Where the hull is flat at its end, its control points end there, too.
  const Eigen::AlignedBox3d& box = surface.mesh().box();
  const double low = box.min()[coordinate], high = box.max()[coordinate];
  const double step = kSamePosition * surface.mesh().size();
  if (std::abs(position - low) <= step) return plane_across(axis, low + step);
  if (std::abs(position - high) <= step) return plane_across(axis, high - step);
  return plane_across(axis, position);
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/clipped_polygon.h"

namespace hull::production {

std::vector<Vector3d> clipped(const std::vector<Vector3d>& polygon, int axis, double at,
                              double sign) {
  std::vector<Vector3d> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double ha = sign * (a[axis] - at), hb = sign * (b[axis] - at);
    if (ha >= 0.0) result.push_back(a);
    if ((ha < 0.0) != (hb < 0.0)) result.push_back(a + ha / (ha - hb) * (b - a));
  }
  return result;
}

}  // namespace hull::production

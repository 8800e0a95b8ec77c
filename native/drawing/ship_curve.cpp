// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/ship_curve.h"

namespace hull {

using Eigen::Vector3d;

namespace {

Vector3d crossing(const Vector3d& a, const Vector3d& b, int axis, double limit) {
  const double t = (limit - a[axis]) / (b[axis] - a[axis]);
  Vector3d point = a + t * (b - a);
  point[axis] = limit;
  return point;
}

}  // namespace

std::vector<std::vector<Vector3d>> part_of_curve(const std::vector<Vector3d>& curve, int axis,
                                                 double limit, Side side) {
  const auto kept = [&](const Vector3d& point) {
    return side == Side::kAbove ? point[axis] >= limit : point[axis] <= limit;
  };
  std::vector<std::vector<Vector3d>> parts;
  std::vector<Vector3d> part;
  const auto finish = [&] {
    if (part.size() > 1) parts.push_back(part);
    part.clear();
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool now = kept(curve[i]);
    if (i > 0 && now != kept(curve[i - 1])) {
      const Vector3d& inside = now ? curve[i] : curve[i - 1];
      // Where the kept end is on the limit itself it is the crossing.
      if (inside[axis] != limit) part.push_back(crossing(curve[i - 1], curve[i], axis, limit));
      if (!now) finish();
    }
    if (now) part.push_back(curve[i]);
  }
  finish();
  return parts;
}

}  // namespace hull

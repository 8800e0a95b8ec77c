// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vectors.h"

namespace hull::morphing {

// The box around a hull, by which places of hulls of different dimensions are compared.
struct HullBox {
  Vector3d low, high;

  // From 0 to 1 along each axis; 0 along one without extent.
  Vector3d relative(const Vector3d& p) const {
    Vector3d at = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = high[axis] - low[axis];
      if (extent > 0.0) at[axis] = (p[axis] - low[axis]) / extent;
    }
    return at;
  }
  Vector3d absolute(const Vector3d& relative) const {
    return low + relative.cwiseProduct(high - low);
  }
};

// REQUIRES: at least one point.
inline HullBox box_of(const std::vector<Vector3d>& points) {
  HullBox box{points.front(), points.front()};
  for (const Vector3d& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

// The side of the centre plane on which more of it is: 1 to port, -1 to starboard.
inline double side_of(const HullBox& box) { return box.low.y() + box.high.y() < 0.0 ? -1.0 : 1.0; }

}  // namespace hull::morphing

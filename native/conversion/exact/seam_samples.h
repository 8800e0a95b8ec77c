// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/exact/corner_net.h"

namespace hull::conversion {

// The functions along a seam, as the nets of the squares before and after it have them.
struct SeamPoint {
  CornerFunctions before, after;
};

// What the angle at a point of a seam depends on: the seam's tangent and the derivatives across it
// in the square before and the one after.
struct SeamVectors {
  Vector3d along, before, after;
};

// The slope at 0 of function 1 across a seam, and of function 0 with the other sign.
double first_slope(int inner);

// Where a seam between two corner squares is looked at; along it from 0 to 1.
class SeamSamples {
 public:
  // So many places between two of its knots, and, to be measured, some more near the irregular
  // point.
  static SeamSamples for_fit(const CornerNet& before, const CornerNet& after);
  static SeamSamples for_measuring(const CornerNet& before, const CornerNet& after);

  int count() const { return static_cast<int>(points_.size()); }
  const SeamPoint& point(int k) const { return points_[k]; }
  SeamVectors vectors(int k, const CornerNet& before, const CornerNet& after) const;

 private:
  SeamSamples(const CornerNet& before, const CornerNet& after, const std::vector<double>& places);

  std::vector<SeamPoint> points_;
};

}  // namespace hull::conversion

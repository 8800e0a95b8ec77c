// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_heights.h"

#include <algorithm>
#include <limits>

namespace hull::analysis {

HeightRange height_range(const HullBody& body, const Vector3d& direction) {
  HeightRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (const Vector3d& p : body.surface().mesh().points()) {
    for (double side : {1.0, -1.0}) {
      const double h = direction.dot(Vector3d(p.x(), side * p.y(), p.z()));
      range.low = std::min(range.low, h);
      range.high = std::max(range.high, h);
      if (!body.mirrored()) break;
    }
  }
  return range;
}

}  // namespace hull::analysis

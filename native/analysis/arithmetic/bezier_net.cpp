// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/bezier_net.h"

#include "surface/wide_code.h"

namespace hull::analysis {

// As BezierBicubic::from_bspline(), in wide code: the second loop takes all four columns at once.
HULL_WIDE BezierNet bezier_net(const surface::BicubicPoints& points, const Vector3d& direction,
                               double offset) {
  BezierNet rows, net;
  for (int j = 0; j < 4; ++j) {
    double p[4];
    for (int i = 0; i < 4; ++i) p[i] = direction.dot(points[4 * j + i]) - offset;
    rows[4 * j] = (p[0] + 4.0 * p[1] + p[2]) / 6.0;
    rows[4 * j + 1] = (2.0 * p[1] + p[2]) / 3.0;
    rows[4 * j + 2] = (p[1] + 2.0 * p[2]) / 3.0;
    rows[4 * j + 3] = (p[1] + 4.0 * p[2] + p[3]) / 6.0;
  }
  for (int i = 0; i < 4; ++i) {
    const double p0 = rows[i], p1 = rows[4 + i], p2 = rows[8 + i], p3 = rows[12 + i];
    net[i] = (p0 + 4.0 * p1 + p2) / 6.0;
    net[4 + i] = (2.0 * p1 + p2) / 3.0;
    net[8 + i] = (p1 + 2.0 * p2) / 3.0;
    net[12 + i] = (p1 + 4.0 * p2 + p3) / 6.0;
  }
  return net;
}

}  // namespace hull::analysis

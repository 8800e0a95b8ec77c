// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/developable_strip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using hull::Vector3d;
using namespace hull::production;

BezierSpan straight(const Vector3d& a, const Vector3d& b) {
  return {a, (2.0 * a + b) / 3.0, (a + 2.0 * b) / 3.0, b};
}

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Around an end of a, over corners of b, which no step falls on: by plane triangles.
TEST(DevelopableStrip, ConesKeepTheAnglesOfCurvesWithCorners) {
  const std::vector<Vector3d> corners{{0, 2, 0}, {1, 2, 0.5}, {1.5, 1, 1.5}, {3, 1, 1}};
  std::vector<BezierSpan> spans;
  for (int k = 0; k < 3; ++k) spans.push_back(straight(corners[k], corners[k + 1]));
  const BezierChain a({straight({0, 0, 0}, {1, 0, 0})}), b(spans);
  for (const bool is_last : {false, true}) {
    // The core is one ruling: the cone runs on from b's start, or back from its end.
    DevelopableStrip strip{{{0, 0}, {0, 0.7}, {0, 2.4}, {0, 3}}, 0, 0};
    if (is_last) strip.first = strip.last = 3;
    const DevelopedStrip flat = developed(a, b, strip);
    double whole = 0.0;
    for (int i = 0; i < 3; ++i) {
      double exact = 0.0;
      double t = strip.rulings[i].t;
      while (t < strip.rulings[i + 1].t) {
        const double next = std::min(std::floor(t) + 1.0, strip.rulings[i + 1].t);
        const Vector3d end = next < 3.0 ? b.at(next).point : corners[3];
        exact += angle_between(b.at(t).point, end);
        t = next;
      }
      const Eigen::Vector2d one = flat.b[i] - flat.a[i], other = flat.b[i + 1] - flat.a[i + 1];
      const double found = std::atan2(std::abs(hull::cross(one, other)), one.dot(other));
      EXPECT_NEAR(found, exact, 1e-9) << i;
      whole += exact;
    }
    EXPECT_GT(whole, 0.5);
  }
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/ruled_warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hull::production {
namespace {

TEST(BernsteinTest, ProductsAndHalvesAreThoseOfTheValues) {
  const Bernstein a{1.0, -2.0, 0.5}, b{0.3, 0.7, -1.0, 2.0};
  const Bernstein both = product(a, b);
  EXPECT_EQ(both.size(), 6u);
  const auto [low, high] = halves(both);
  for (double t = 0.0; t <= 1.0; t += 0.125) {
    EXPECT_NEAR(value(both, t), value(a, t) * value(b, t), 1e-14);
    EXPECT_NEAR(value(low, t), value(both, 0.5 * t), 1e-14);
    EXPECT_NEAR(value(high, t), value(both, 0.5 + 0.5 * t), 1e-14);
  }
}

TEST(RuledWarpTest, BoundIsAboveAllSamples) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal(0.0, 0.2);
  for (int k = 0; k < 300; ++k) {
    BezierSpan a, b;
    for (int i = 0; i < 4; ++i) {
      a[i] = Vector3d(i + normal(random), normal(random), normal(random));
      b[i] = Vector3d(i + normal(random), 1.0 + normal(random), normal(random));
    }
    const LargestWarp worst = largest_warp(a, b);
    for (double t = 0.0; t <= 1.0; t += 1.0 / 256.0) {
      EXPECT_LE(warp_at(a, b, t), worst.bound) << "seed 17, " << k;
    }
  }
}

// Moved, mirrored, or run through from the other end, a strip has the same warp; scaled up, less.
TEST(RuledWarpTest, GoesWithTheShapeAlone) {
  const BezierSpan a{Vector3d(0, 0, 0), Vector3d(1, 0.2, 0), Vector3d(2, 0.1, 0.4),
                     Vector3d(3, 0, 0)};
  const BezierSpan b{Vector3d(0, 1, 0.3), Vector3d(1, 1.2, 0), Vector3d(2, 1, 0),
                     Vector3d(3, 1, 1)};
  const double wanted = largest_warp(a, b).found;
  BezierSpan c, d;
  for (int i = 0; i < 4; ++i) {
    c[i] = 3.0 * Vector3d(a[3 - i].x(), -a[3 - i].y(), a[3 - i].z()) + Vector3d(5, 6, 7);
    d[i] = 3.0 * Vector3d(b[3 - i].x(), -b[3 - i].y(), b[3 - i].z()) + Vector3d(5, 6, 7);
  }
  EXPECT_NEAR(largest_warp(d, c).found, wanted / 3.0, 1e-3 * wanted);
}

TEST(RuledWarpTest, IsInfiniteWhereARulingHasNoLength) {
  const BezierSpan a{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(2, 0, 0), Vector3d(3, 0, 0)};
  BezierSpan b = a;
  for (int i = 1; i < 4; ++i) b[i] += Vector3d(0, 0.5 * i, 0.1 * i * i);
  EXPECT_EQ(largest_warp(a, b).bound, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hull::production

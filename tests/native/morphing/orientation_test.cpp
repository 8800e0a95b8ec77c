// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hull::morphing {
namespace {

// Of whole numbers of up to 2^31, by whole numbers of 128 bits.
__extension__ typedef __int128 Wide;

Wide exact_area_of(const long long* p) {
  return Wide(p[0] - p[4]) * (p[3] - p[5]) - Wide(p[1] - p[5]) * (p[2] - p[4]);
}

// Coordinates of 53 bits whose differences and products do not fit into a double: a line of large
// numbers, and points beside it by a few units.
TEST(Orientation, SignsAndValuesAreThoseOfWholeNumbers) {
  constexpr unsigned kSeed = 20261124;
  std::mt19937_64 random(kSeed);
  std::uniform_int_distribution<long long> any(-(1LL << 52), 1LL << 52), few(-2, 2);
  int zeros = 0, sliver = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    long long p[6] = {any(random) / 4, any(random) / 4, any(random) / 4, any(random) / 4, 0, 0};
    // A third point on the line, or nearly so.
    const long long times = few(random);
    p[4] = p[0] + times * (p[2] - p[0]) / 2 + few(random) / 2;
    p[5] = p[1] + times * (p[3] - p[1]) / 2 + few(random) / 2;
    const double scale = std::ldexp(1.0, -50);
    const Vector2d a(p[0] * scale, p[1] * scale), b(p[2] * scale, p[3] * scale),
        c(p[4] * scale, p[5] * scale);
    const Wide wanted = exact_area_of(p);
    const double found = orientation(a, b, c);
    ASSERT_EQ(found > 0.0, wanted > 0) << "seed " << kSeed << ", trial " << trial;
    ASSERT_EQ(found < 0.0, wanted < 0) << "seed " << kSeed << ", trial " << trial;
    const double value = static_cast<double>(static_cast<long double>(wanted)) * scale * scale;
    EXPECT_NEAR(found, value, 1e-13 * std::abs(value));
    EXPECT_EQ(orientation(b, a, c), -found);
    zeros += wanted == 0;
    sliver += wanted != 0 && std::abs(found) < 1e-12;
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(sliver, 1000);
}

TEST(Orientation, IsTwiceTheArea) {
  EXPECT_EQ(orientation({0, 0}, {2, 0}, {0, 3}), 6.0);
  EXPECT_EQ(orientation({0, 0}, {0, 3}, {2, 0}), -6.0);
  EXPECT_EQ(orientation({0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}), 0.0);
}

}  // namespace
}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/bracketed_maximum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hull::analysis {
namespace {

// Hills of many shapes, smooth, with kinks and cusps, skew and flat: all are found to the width
// asked for; golden sections would take 30 calls for any of them, and smooth ones take 14 at most.
TEST(BracketedMaximum, FindsTheTopOfAnyHill) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  constexpr double kWidth = 1e-6;
  int smooth_calls = 0, smooth_hills = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double top = unit(random), left = 0.2 + 3.0 * unit(random),
                 right = 0.2 + 3.0 * unit(random);
    const int shape = trial % 4;
    int calls = 0;
    const auto hill = [&](double x) {
      ++calls;
      const double r = x - top, slope = r < 0.0 ? left : right;
      switch (shape) {
        case 0:
          return std::cos(2.0 * r) + 0.1 * r * r * r;
        case 1:
          return -slope * std::abs(r);
        case 2:
          return -slope * std::sqrt(std::abs(r));
        default:
          return -slope * r * r;
      }
    };
    const Maximum found = bracketed_maximum(hill, 0.0, 1.0, kWidth);
    ASSERT_NEAR(found.place, top, kWidth) << "trial " << trial << " shape " << shape;
    ASSERT_EQ(found.value, hill(found.place));
    ASSERT_LT(calls, 80) << "shape " << shape;
    if (shape == 0) {
      smooth_calls += calls;
      ++smooth_hills;
    }
  }
  EXPECT_LT(smooth_calls, 14 * smooth_hills);
}

TEST(BracketedMaximum, MayBeAtAnEnd) {
  const auto rising = [](double x) { return x; };
  EXPECT_NEAR(bracketed_maximum(rising, 2.0, 3.0, 1e-9).place, 3.0, 2e-9);
  const auto level = [](double) { return 1.0; };
  const Maximum found = bracketed_maximum(level, 2.0, 3.0, 1e-9);
  EXPECT_TRUE(found.place >= 2.0 && found.place <= 3.0);
}

}  // namespace
}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/bracketed_root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hull::analysis {
namespace {

TEST(BracketedRoot, IsThatOfSmoothFunctions) {
  const auto f = [](double x) { return std::exp(x) - 2.0; };
  EXPECT_NEAR(bracketed_root(f, 0.0, f(0.0), 1.0, f(1.0), 1e-14), std::log(2.0), 1e-13);
  EXPECT_NEAR(bracketed_root(f, 1.0, f(1.0), 0.0, f(0.0), 1e-14), std::log(2.0), 1e-13);
}

// Where fb outweighs fa, the step from b is as long as the bracket but for rounding.
TEST(BracketedRoot, NeverAsksOutsideOfTheBracket) {
  constexpr unsigned kSeed = 20261122;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 10000; ++trial) {
    const double b = unit(random), slope = unit(random), root = 1e-17 * unit(random);
    const auto f = [&](double x) {
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, b);
      return slope * (x - root);
    };
    const double found = bracketed_root(f, 0.0, -slope * root, b, slope * (b - root), 1e-14);
    EXPECT_NEAR(found, root, 1e-14);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace hull::analysis

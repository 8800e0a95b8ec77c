// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/gauss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hull::analysis {
namespace {

constexpr double kGaussRounding = 4.0 * std::numeric_limits<double>::epsilon();

TEST(Gauss, RulesAreExactToTheirDegree) {
  for (int n = 1; n <= 20; ++n) {
    const GaussRule rule = gauss_rule(n);
    for (int power = 0; power < 2 * n; ++power) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      EXPECT_NEAR(sum, 1.0 / (power + 1.0), n * kGaussRounding) << n << " nodes, power " << power;
    }
  }
}

TEST(Gauss, ConstantsAreTheRulesOfFewNodes) {
  for (const ShortGaussRule& constant : {kTwoNodes, kThreeNodes, kFourNodes}) {
    const GaussRule rule = gauss_rule(constant.count);
    for (int i = 0; i < constant.count; ++i) {
      EXPECT_NEAR(constant.nodes[i], rule.nodes[i], kGaussRounding) << constant.count;
      EXPECT_NEAR(constant.weights[i], rule.weights[i], kGaussRounding) << constant.count;
    }
  }
}

}  // namespace
}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/bezier.h"

#include <gtest/gtest.h>

namespace hull::analysis {
namespace {

// Zero counts as positive: at an end it is no change of sign where the cubic goes on above.
TEST(SignChanges, AreNotAtEndsThatTouchZero) {
  for (const BezierCubic& c : {BezierCubic{0.0, 1.0, 1.0, -1.0}, BezierCubic{0.0, 0.1, -1.0, -1.0},
                               BezierCubic{-1.0, 1.0, 1.0, 0.0}}) {
    const Roots roots = sign_changes(c);
    ASSERT_EQ(roots.size(), 1u);
    EXPECT_GT(roots.front(), 1e-3);
    EXPECT_LT(roots.front(), 1.0 - 1e-3);
    EXPECT_NEAR(evaluate(c, roots.front()), 0.0, 1e-15);
  }
}

TEST(SignChanges, AreAtEndsThatTheCubicLeavesDownwards) {
  EXPECT_NEAR(sign_changes({0.0, -1.0, -2.0, -1.0}).front(), 0.0, 1e-15);
  EXPECT_NEAR(sign_changes({-1.0, -2.0, -1.0, 0.0}).front(), 1.0, 1e-15);
  EXPECT_TRUE(sign_changes({0.0, 1.0, 1.0, 0.0}).empty());
}

}  // namespace
}  // namespace hull::analysis

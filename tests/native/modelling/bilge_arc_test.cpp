// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/bilge_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hull::modelling {
namespace {

// The deviations that were found with another program's minimax search of the same unknowns (SLSQP
// over all spans, without symmetry, from random starts).
TEST(BilgeArc, ReachesTheDeviationsFoundOtherwise) {
  const double right_angle = 0.5 * std::numbers::pi;
  const double touching[] = {8.43e-4, 3.45e-4, 1.664e-4};
  const double apart[] = {3.10e-4, 1.427e-4, 7.46e-5};
  const BilgeBorder best{BilgeBorder::Kind::kBest};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(bilge_arc(4 + i, right_angle).deviation, touching[i], 2e-3 * touching[i]);
    EXPECT_NEAR(bilge_arc(4 + i, right_angle, best, best).deviation, apart[i], 2e-3 * apart[i]);
  }
}

// Small angles: an arc nearly is a parabola, and all is similar: deviations go with the square.
TEST(BilgeArc, IsSimilarForSmallAngles) {
  const double degree = std::numbers::pi / 180.0;
  const double a = bilge_arc(4, 20.0 * degree).deviation;
  const double b = bilge_arc(4, 10.0 * degree).deviation;
  EXPECT_NEAR(a / b, 4.0, 0.1);
}

}  // namespace
}  // namespace hull::modelling

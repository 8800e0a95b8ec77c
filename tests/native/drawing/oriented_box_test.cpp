// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/oriented_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drawing/lines_plan/ship_curve.h"
#include "drawing/paper/text_meter.h"

namespace hull::drawing {
namespace {

using Eigen::Vector2d;

bool inside(const OrientedBox& box, const Vector2d& point) {
  const Vector2d away = point - box.centre;
  const Vector2d along(std::cos(box.angle), std::sin(box.angle));
  const Vector2d across(-along.y(), along.x());
  return std::abs(away.dot(along)) < box.half.x() && std::abs(away.dot(across)) < box.half.y();
}

// Against points sampled in the one box and asked of the other.
TEST(OrientedBox, OverlapAgreesWithSampledPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3.0, 3.0), half(0.3, 2.0), turn(-3.2, 3.2);
  const auto box = [&] {
    return OrientedBox{{place(random), place(random)}, {half(random), half(random)}, turn(random)};
  };
  int overlapping = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const OrientedBox a = box(), b = box();
    const auto corners = a.corners();
    bool shared = false;
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j <= 60; ++j) {
        const Vector2d point = corners[0] + (corners[1] - corners[0]) * (i / 60.0) +
                               (corners[3] - corners[0]) * (j / 60.0);
        shared = shared || inside(b, point);
      }
    }
    // Boxes that overlap by more than the samples' distance are found by them.
    if (shared) {
      EXPECT_TRUE(overlap(a, b)) << trial;
    } else {
      EXPECT_FALSE(overlap(a.grown(-0.1), b.grown(-0.1))) << trial;
    }
    overlapping += shared;
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_LT(overlapping, 250);
}

TEST(OrientedBox, OverlapOfSegments) {
  const OrientedBox box{{0.0, 0.0}, {2.0, 1.0}, 0.0};
  EXPECT_TRUE(overlap(box, {-3.0, 0.0}, {3.0, 0.0}));
  EXPECT_TRUE(overlap(box, {0.0, 0.0}, {0.5, 0.5}));
  EXPECT_FALSE(overlap(box, {-3.0, 1.0}, {3.0, 1.0}));  // along a side
  EXPECT_FALSE(overlap(box, {1.5, 2.0}, {3.5, 0.0}));   // past a corner
  const OrientedBox turned{{0.0, 0.0}, {2.0, 1.0}, 1.5707963267948966};
  EXPECT_FALSE(overlap(turned, {1.5, -1.0}, {1.5, 1.0}));
  EXPECT_TRUE(overlap(turned, {-0.5, 1.5}, {0.5, 1.5}));
}

TEST(ShipCurve, PartsOnOneSide) {
  const std::vector<Eigen::Vector3d> zigzag = {{0, -1, 0}, {1, 1, 0}, {2, -1, 0}, {3, 0, 0}};
  const auto above = part_of_curve(zigzag, 1, 0.0, LimitSide::kAbove);
  ASSERT_EQ(above.size(), 1u);  // the last touch is a single point
  ASSERT_EQ(above[0].size(), 3u);
  EXPECT_EQ(above[0].front(), Eigen::Vector3d(0.5, 0, 0));
  EXPECT_EQ(above[0].back(), Eigen::Vector3d(1.5, 0, 0));
  EXPECT_EQ(part_of_curve(zigzag, 1, 0.0, LimitSide::kBelow).size(), 2u);
  const std::vector<Eigen::Vector3d> within = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(part_of_curve(within, 1, 0.0, LimitSide::kAbove).size(), 1u);
  EXPECT_EQ(part_of_curve(within, 1, 0.0, LimitSide::kBelow).size(), 1u);
}

TEST(TextMeter, FitsTextsIntoTheirPlace) {
  const double width = text_size("Lines plan", 5.0, false).width;
  EXPECT_EQ(fit_text("Lines plan", 5.0, false, width + 0.1).size, 5.0);
  const FittedText smaller = fit_text("Lines plan", 5.0, false, 0.8 * width);
  EXPECT_EQ(smaller.text, "Lines plan");
  EXPECT_NEAR(text_size(smaller.text, smaller.size, false).width, 0.8 * width, 1e-9);
  const FittedText shortened = fit_text("Žluťoučký kůň pěl ódy", 5.0, true, 15.0);
  EXPECT_LE(text_size(shortened.text, shortened.size, true).width, 15.0 + 1e-9);
  EXPECT_EQ(shortened.text.substr(shortened.text.size() - 3), "…");
}

}  // namespace
}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/bspline_curve.h"

#include <gtest/gtest.h>

#include <random>

namespace hull::conversion {
namespace {

BSplineCurve random_curve(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  BSplineCurve curve{3, {0, 0, 0, 0, 0.001, 0.01, 0.25, 0.5, 0.8, 1, 1, 1, 1}, {}};
  for (int i = 0; i < 9; ++i) curve.points.emplace_back(unit(random), unit(random), unit(random));
  return curve;
}

TEST(BSplineCurve, PartsAreTheSameCurve) {
  const BSplineCurve curve = random_curve(81);
  for (const auto& [begin, end] : {std::pair(0.0, 0.25), std::pair(0.25, 0.8), std::pair(0.3, 1.0),
                                   std::pair(0.005, 0.0051), std::pair(0.0, 1.0)}) {
    const BSplineCurve part = curve.part(begin, end);
    EXPECT_EQ(part.knots.size(), part.points.size() + 4);
    EXPECT_EQ(part.knots.front(), 0.0);
    EXPECT_EQ(part.knots.back(), 1.0);
    for (double t : {0.0, 0.1, 0.35, 0.77, 1.0}) {
      EXPECT_LT((part.position(t) - curve.position(begin + t * (end - begin))).norm(), 1e-14);
    }
    EXPECT_LT((part.points.front() - curve.position(begin)).norm(), 1e-14);
  }
}

// Reversed knots are off by rounding; no interval of that size may appear.
TEST(BSplineCurve, PartsOfReversedCurvesEndAtKnots) {
  BSplineCurve curve = random_curve(82);
  curve.knots[6] = 1.0 / 3.0;
  const BSplineCurve back = curve.reversed();
  const BSplineCurve part = back.part(1.0 - 0.5, 1.0 - 1.0 / 3.0 + 1e-16);
  EXPECT_EQ(part.points.size(), 4u);
  EXPECT_LT(gap_between(part.reversed(), curve.part(1.0 / 3.0, 0.5)), 1e-14);
}

TEST(BSplineCurve, ClampedIsTheSameCurve) {
  const BSplineCurve open{3,
                          {-1.5, -1.0, -0.25, 0.0, 1.0, 2.5, 3.0, 3.0, 4.0, 5.0},
                          {{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {3, 0, 2}, {4, 1, 1}, {5, 0, 0}}};
  const BSplineCurve curve = clamped(open);
  EXPECT_EQ(curve.knots, (std::vector<double>{0, 0, 0, 0, 1.0 / 3, 2.5 / 3, 1, 1, 1, 1}));
  // The blossom (Ramshaw 1989): the polynomial of each span evaluated by de Boor's recursion.
  const auto de_boor = [&](double t) {
    int span = 3;
    while (span < 5 && t >= open.knots[span + 1]) ++span;
    std::vector<Vector3d> d(open.points.begin() + span - 3, open.points.begin() + span + 1);
    for (int r = 1; r <= 3; ++r) {
      for (int j = 3; j >= r; --j) {
        const double low = open.knots[j + span - 3], high = open.knots[j + 1 + span - r];
        const double share = (t - low) / (high - low);
        d[j] = (1.0 - share) * d[j - 1] + share * d[j];
      }
    }
    return d[3];
  };
  for (double t : {0.0, 0.2, 0.9, 1.0, 1.7, 2.4, 2.6, 2.999}) {
    EXPECT_LT((curve.position(t / 3.0) - de_boor(t)).norm(), 1e-14) << t;
  }
  const BSplineCurve again = clamped(curve);
  EXPECT_EQ(again.knots, curve.knots);
  EXPECT_EQ(again.points, curve.points);
}

TEST(BSplineCurve, GapsAreThoseOfTheCurvesAndNotOfTheirKnots) {
  const BSplineCurve curve = random_curve(83);
  EXPECT_LT(gap_between(curve, curve.reversed().reversed()), 1e-15);
  BSplineCurve other = curve;
  other.points[2].y() += 1e-6;
  EXPECT_GT(gap_between(curve, other), 1e-7);
  EXPECT_LE(gap_between(curve, other), 1e-6);
}

}  // namespace
}  // namespace hull::conversion

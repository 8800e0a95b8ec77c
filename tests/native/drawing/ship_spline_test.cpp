// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/ship_spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "drawing/lines_plan/ship_curve.h"

namespace hull::drawing {
namespace {

// Random points over knots of uneven distance, which do not end in the first and last point.
surface::CubicSpline random_spline(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0), step(0.2, 1.5);
  std::vector<Vector3d> points;
  std::vector<double> knots{0.0};
  for (int i = 0; i < 9; ++i) {
    const double x = i + 0.3 * number(random), y = number(random), z = number(random);
    points.emplace_back(x, y, z);
  }
  while (knots.size() < points.size() + 4) knots.push_back(knots.back() + step(random));
  return surface::CubicSpline(points, knots);
}

TEST(ShipSpline, PartsAreTheSameCurve) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const surface::CubicSpline whole = random_spline(random);
    std::uniform_real_distribution<double> place(whole.begin(), whole.end());
    double from = place(random), to = place(random);
    if (from > to) std::swap(from, to);
    if (round == 0) from = whole.begin(), to = whole.end();
    const surface::CubicSpline part = part_of_spline(whole, from, to);
    EXPECT_EQ(part.begin(), from);
    EXPECT_EQ(part.end(), to);
    EXPECT_LT((part.points().front() - whole.evaluate(from, 0).point).norm(), 1e-12);
    EXPECT_LT((part.points().back() - whole.evaluate(to, 0).point).norm(), 1e-12);
    for (int i = 0; i <= 20; ++i) {
      const double t = from + (to - from) * i / 20.0;
      const surface::CurveJet a = part.evaluate(std::min(t, to), 2);
      const surface::CurveJet b = whole.evaluate(std::min(t, to), 2);
      EXPECT_LT((a.point - b.point).norm(), 1e-11);
      EXPECT_LT((a.d1 - b.d1).norm(), 1e-9);
    }
    // And parts of a clamped one, which a part is.
    const surface::CubicSpline again = part_of_spline(part, part.begin(), 0.5 * (from + to));
    EXPECT_LT((again.points().back() - whole.evaluate(0.5 * (from + to), 0).point).norm(), 1e-12);
  }
}

TEST(ShipSpline, CrossingsAreWhereTheSideChanges) {
  std::mt19937 random(12);
  for (int round = 0; round < 50; ++round) {
    const surface::CubicSpline spline = random_spline(random);
    const std::vector<double> found = crossings_of_spline(spline, 1, 0.1);
    double previous = spline.begin();
    for (const double t : found) {
      EXPECT_GT(t, previous);
      EXPECT_NEAR(spline.evaluate(t, 0).point.y(), 0.1, 1e-12);
      previous = t;
    }
    const bool starts_above = spline.evaluate(spline.begin(), 0).point.y() >= 0.1;
    const bool ends_above = spline.evaluate(spline.end(), 0).point.y() >= 0.1;
    EXPECT_EQ(starts_above != ends_above, found.size() % 2 == 1);
  }
}

TEST(ShipSpline, PartsOfCurvesKeepTheirSplines) {
  std::mt19937 random(13);
  for (int round = 0; round < 20; ++round) {
    const surface::CubicSpline spline = random_spline(random);
    ShipCurve curve{{}, spline};
    for (int i = 0; i <= 2000; ++i) {
      const double t = spline.begin() + (spline.end() - spline.begin()) * i / 2000.0;
      curve.points.push_back(spline.evaluate(std::min(t, spline.end()), 0).point);
    }
    for (const LimitSide side : {LimitSide::kAbove, LimitSide::kBelow}) {
      for (const ShipCurve& part : part_of_curve(curve, 1, 0.0, side)) {
        ASSERT_TRUE(part.spline);
        const surface::CubicSpline& own = *part.spline;
        EXPECT_LT((own.evaluate(own.begin(), 0).point - part.points.front()).norm(), 1e-4);
        EXPECT_LT((own.evaluate(own.end(), 0).point - part.points.back()).norm(), 1e-4);
      }
    }
  }
}

// A crossing makes up for the end that is cut off, and the part has as many points as the curve.
TEST(ShipSpline, PartsEndAtTheLimitThoughOnlyAnEndIsBeyond) {
  std::mt19937 random(14);
  const surface::CubicSpline spline = random_spline(random);
  ShipCurve curve{{}, spline};
  for (int i = 0; i <= 40; ++i) {
    const double t = spline.begin() + (spline.end() - spline.begin()) * i / 40.0;
    curve.points.push_back(spline.evaluate(std::min(t, spline.end()), 0).point);
  }
  // x rises along it.
  const double limit = 0.5 * (curve.points[39].x() + curve.points[40].x());
  const std::vector<ShipCurve> parts = part_of_curve(curve, 0, limit, LimitSide::kBelow);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].points.size(), curve.points.size());
  ASSERT_TRUE(parts[0].spline);
  const surface::CubicSpline& own = *parts[0].spline;
  EXPECT_NEAR(own.evaluate(own.end(), 0).point.x(), limit, 1e-12);
  // What is not cut keeps its own.
  const std::vector<ShipCurve> whole = part_of_curve(curve, 0, 100.0, LimitSide::kBelow);
  ASSERT_TRUE(whole.size() == 1 && whole[0].spline);
  EXPECT_EQ(whole[0].spline->points(), spline.points());
}

TEST(ShipSpline, CurvesThatEndInTheCentrePlaneMeetItInFiles) {
  std::mt19937 random(15);
  const surface::CubicSpline spline = random_spline(random);
  ShipCurve curve{{}, spline};
  for (int i = 0; i <= 40; ++i) {
    const double t = spline.begin() + (spline.end() - spline.begin()) * i / 40.0;
    const Vector3d p = spline.evaluate(std::min(t, spline.end()), 0).point;
    curve.points.emplace_back(p.y(), i, p.z());
  }
  // Nearer by its first point, and by the first two.
  for (const double least : {0.5, 1.5}) {
    const std::vector<ShipCurve> parts = parts_off_centre(curve, least);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].points.front().y(), least);
    const bool is_whole = parts[0].spline && parts[0].spline->points() == spline.points();
    EXPECT_EQ(is_whole, least < 1.0);
  }
}

}  // namespace
}  // namespace hull::drawing

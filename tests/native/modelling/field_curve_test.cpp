// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/field_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "modelling/fields/arc_foot.h"
#include "modelling/fields/curve_change.h"

namespace hull::modelling {
namespace {

using Points = std::vector<Vector3d>;

Points random_points(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  Points points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(2.0 * i + place(random), 3 * place(random), 3 * place(random));
  }
  return points;
}

TEST(FieldCurve, GoesThroughItsPoints) {
  std::mt19937 random(1);
  const Points points = random_points(random, 9);
  for (bool closed : {false, true}) {
    const FieldCurve curve = FieldCurve::through(points, {4}, closed);
    EXPECT_EQ(curve.arcs().size(), points.size() - (closed ? 0 : 1));
    for (const Vector3d& p : points) EXPECT_LT(curve.foot(p).distance, 1e-14);
  }
}

TEST(FieldCurve, BendsWithoutJumpsButAtKnuckles) {
  std::mt19937 random(2);
  const Points points = random_points(random, 8);
  for (bool closed : {false, true}) {
    const FieldCurve curve = FieldCurve::through(points, {}, closed);
    const auto& arcs = curve.arcs();
    for (std::size_t i = 0; i < arcs.size() - (closed ? 0 : 1); ++i) {
      // By chord length: derivatives by the same parameter.
      const std::size_t next = (i + 1) % arcs.size();
      const double own = (arcs[i][3] - arcs[i][0]).norm(),
                   other = (arcs[next][3] - arcs[next][0]).norm();
      const auto end = arc_jet(arcs[i], 1.0), begin = arc_jet(arcs[next], 0.0);
      EXPECT_LT((end.d1 / own - begin.d1 / other).norm(), 1e-13);
      EXPECT_LT((end.d2 / (own * own) - begin.d2 / (other * other)).norm(), 1e-12);
    }
  }
  const FieldCurve curve = FieldCurve::through(points, {3});
  const Vector3d before = arc_jet(curve.arcs()[2], 1.0).d1.normalized(),
                 after = arc_jet(curve.arcs()[3], 0.0).d1.normalized();
  EXPECT_GT((before - after).norm(), 0.1);
}

TEST(FieldCurve, IsTheSplineItIsMadeOf) {
  const surface::CubicSpline spline(
      {{0, 0, 0}, {1, 2, 0}, {2, 1, 1}, {4, 0, 2}, {5, 1, 0}, {6, 3, 1}},
      {0, 1, 2, 3, 4, 5.5, 6, 7, 8, 9});
  const FieldCurve curve = FieldCurve::of_spline(spline);
  for (int i = 0; i <= 200; ++i) {
    const double t = spline.begin() + (spline.end() - spline.begin()) * i / 200;
    EXPECT_LT(curve.foot(spline.evaluate(t, 0).point).distance, 1e-14);
  }
}

TEST(FieldCurve, FindsTheNearestOfAllPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  for (int trial = 0; trial < 20; ++trial) {
    const FieldCurve curve = FieldCurve::through(random_points(random, 6));
    for (int k = 0; k < 20; ++k) {
      const Vector3d p(5 + 2 * place(random), place(random), place(random));
      double least = std::numeric_limits<double>::infinity();
      for (const auto& arc : curve.arcs()) {
        for (int i = 0; i <= 2000; ++i) {
          least = std::min(least, (arc_jet(arc, i / 2000.0).point - p).norm());
        }
      }
      const CurveFoot foot = curve.foot(p);
      EXPECT_LE(foot.distance, least + 1e-14);
      // Between samples the distance falls by the square of their distance at most.
      EXPECT_GT(foot.distance, least - 2e-5);
      EXPECT_LT((curve.point_at(foot.length) - foot.point).norm(), 1e-11);
    }
  }
}

TEST(FieldCurve, FindsTheNearestPointOfACircle) {
  Points points;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2 * std::numbers::pi * i / 48;
    points.emplace_back(10 * std::cos(angle), 10 * std::sin(angle), 0);
  }
  const FieldCurve circle = FieldCurve::through(points, {}, true);
  // An interpolated circle is off by the fourth power of the angle.
  EXPECT_NEAR(circle.length(), 20 * std::numbers::pi, 1e-4);
  const CurveFoot foot = circle.foot({0, 4, 3});
  EXPECT_NEAR(foot.distance, std::hypot(6, 3), 1e-4);
  EXPECT_NEAR(foot.length_slope.norm(), 10.0 / 4.0, 1e-2);
}

TEST(FieldCurve, LengthSlopesAreThoseOfDifferences) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const FieldCurve curve = FieldCurve::through(random_points(random, 6));
  for (int k = 0; k < 200; ++k) {
    const double length = curve.length() * (0.5 + 0.49 * place(random));
    const Vector3d p = curve.point_at(length) + 0.02 * Vector3d(place(random), 1, place(random));
    const CurveFoot foot = curve.foot(p);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = 1e-6 * Vector3d::Unit(axis);
      const double slope = (curve.foot(p + step).length - curve.foot(p - step).length) / 2e-6;
      EXPECT_NEAR(foot.length_slope[axis], slope, 1e-6);
    }
  }
}

TEST(FieldCurve, RefusesWhatIsNone) {
  EXPECT_THROW(FieldCurve::through({{0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(FieldCurve::through({{0, 0, 0}, {0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(FieldCurve::through({{0, 0, 0}, {1, 0, 0}}, {2}), std::invalid_argument);
  EXPECT_THROW(FieldCurve::through({{0, 0, 0}, {1, 0, 0}}, {}, true), std::invalid_argument);
  EXPECT_THROW(FieldCurve::through({{0, 0, 0}, {std::nan(""), 0, 0}}), std::invalid_argument);
  EXPECT_THROW(FieldCurve(std::vector<FieldCurve::Arc>{}), std::invalid_argument);
}

// A stem: straight down, and on as a straight keel or by a bulb, and straight again.
FieldCurve stem(double bulb) {
  Points points{{10, 0, 8}, {10, 0, 7}, {10, 0, 6}, {10, 0, 5}};
  for (int i = 1; i < 8; ++i) {
    const double part = i / 8.0;
    points.emplace_back(10 + bulb * std::pow(std::sin(std::numbers::pi * part), 2), 0,
                        5 - 4 * part);
  }
  points.insert(points.end(), {{10, 0, 1}, {10, 0, 0}});
  return FieldCurve::through(points, {0, 3, 11, 12});
}

TEST(CurveChange, BringsTheCurveOntoTheOther) {
  const CurveChange change(stem(0), stem(3));
  EXPECT_NEAR(change.begin(), 3.0, 1e-5);
  EXPECT_NEAR(change.end(), 7.0, 1e-5);
  const FieldCurve other = stem(3);
  for (int i = 0; i <= 100; ++i) {
    const double length = change.curve().length() * i / 100;
    const Vector3d to = change.curve().point_at(length) + change.shift(length).value;
    EXPECT_LT(other.foot(to).distance, 1e-12);
    if (length < change.begin() || length > change.end()) {
      EXPECT_EQ(change.shift(length).value, Vector3d::Zero());
    }
  }
}

TEST(CurveChange, HasNoKinkWhereProportionsHaveOne) {
  const FieldCurve curve = stem(0), other = stem(3);
  const CurveChange change(curve, other);
  const double h = 1e-5, at = change.begin();
  const auto slope_after = [&](const auto& map) { return (map(at + 2 * h) - map(at + h)) / h; };
  // The paper's map: equal proportions of the lengths between.
  const double stretch = change.end() - change.begin(),
               other_stretch = other.length() - (curve.length() - stretch);
  const auto proportional = [&](double l) { return at + (l - at) / stretch * other_stretch; };
  const double jump = other_stretch / stretch - 1.0;
  EXPECT_GT(jump, 0.3);
  EXPECT_NEAR(slope_after(proportional) - 1.0, jump, 1e-9);
  EXPECT_NEAR(slope_after([&](double l) { return change.mapped(l).value; }) - 1.0, 0.0, 1e-6);
  EXPECT_NEAR(change.mapped(change.end()).value, other.length() - curve.length() + change.end(),
              1e-12);
}

TEST(CurveChange, TheMapRisesWhateverTheLengths) {
  for (double bulb : {-30.0, 0.5, 30.0}) {
    for (const auto& [from, to] : {std::pair(0.0, bulb), std::pair(bulb, 0.0)}) {
      const CurveChange change(stem(from), stem(to));
      for (int i = 0; i <= 1000; ++i) {
        EXPECT_GT(change.mapped(change.curve().length() * i / 1000).slope, 0.0);
      }
    }
  }
}

TEST(CurveChange, SlopesAreThoseOfDifferences) {
  const CurveChange change(stem(1), stem(3));
  for (int i = 1; i < 200; ++i) {
    const double at = change.curve().length() * i / 200, h = 1e-6;
    EXPECT_NEAR(change.mapped(at).slope,
                (change.mapped(at + h).value - change.mapped(at - h).value) / (2 * h), 1e-6);
  }
}

TEST(CurveChange, OfACurveThatStaysIsNothing) {
  const CurveChange change(stem(1), stem(1));
  for (int i = 0; i <= 20; ++i) {
    EXPECT_EQ(change.shift(change.curve().length() * i / 20).value, Vector3d::Zero());
  }
}

// Arcs from one number up to another of a curve of straight or bent arcs.
std::vector<FieldCurve::Arc> some_arcs(bool bent, int from, int to) {
  std::vector<FieldCurve::Arc> arcs;
  const auto at = [&](double x) { return Vector3d(x, bent ? 0.1 * x * x : 0.0, 0.0); };
  for (int i = from; i < to; ++i) {
    const double third = 1.0 / 3.0;
    // The parabola in Bézier points: the inner ones are a third along the ends' tangents.
    const Vector3d slope(third, bent ? third * 0.2 * i : 0.0, 0.0);
    const Vector3d slope_after(third, bent ? third * 0.2 * (i + 1) : 0.0, 0.0);
    arcs.push_back({at(i), at(i) + slope, at(i + 1) - slope_after, at(i + 1)});
  }
  return arcs;
}

void expect_onto(const CurveChange& change, const FieldCurve& other) {
  const FieldCurve& curve = change.curve();
  const double length = curve.length(), h = 1e-6;
  EXPECT_NEAR(change.mapped(0.0).value, 0.0, 1e-12);
  EXPECT_NEAR(change.mapped(length).value, other.length(), 1e-12);
  for (int i = 0; i <= 200; ++i) {
    const double at = length * (i / 200.0);
    const ValueAlong<double> mapped = change.mapped(at);
    EXPECT_GT(mapped.slope, 0.0) << at;
    EXPECT_LT((curve.point_at(at) + change.shift(at).value - other.point_at(mapped.value)).norm(),
              1e-12)
        << at;
    if (i == 0 || i == 200) continue;
    EXPECT_NEAR(mapped.slope, (change.mapped(at + h).value - change.mapped(at - h).value) / (2 * h),
                1e-6);
  }
}

TEST(CurveChange, OfACurveThatGoesOnOrEndsSoonerTakesAllOfIt) {
  for (bool bent : {false, true}) {
    const FieldCurve all(some_arcs(bent, 0, 6)), first(some_arcs(bent, 0, 4)),
        last(some_arcs(bent, 3, 6));
    for (const FieldCurve* part : {&first, &last}) {
      const Vector3d kept = part == &first ? Vector3d(0.0, 0.0, 0.0) : all.point_at(all.length());
      for (const CurveChange& change : {CurveChange(*part, all), CurveChange(all, *part)}) {
        const double length = change.curve().length();
        const double stays = part == &first ? 0.0 : length;
        EXPECT_EQ(change.curve().point_at(stays), kept);
        EXPECT_EQ(change.shift(stays).value, Vector3d::Zero());
        // No kink where the curve begins to move.
        EXPECT_NEAR(change.mapped(stays).slope, 1.0, 1e-12);
      }
      expect_onto(CurveChange(*part, all), all);
      expect_onto(CurveChange(all, *part), *part);
    }
  }
}

TEST(CurveChange, OfALineWithALoopMoreTakesAllOfIt) {
  const std::vector<Vector3d> straight{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}};
  std::vector<Vector3d> looped = straight;
  looped.insert(looped.begin() + 2, {{5, 1, 0}, {4, 2, 0}, {3, 1, 0}, {4, 0, 0}});
  const FieldCurve line = FieldCurve::through(straight, {1}),
                   loop = FieldCurve::through(looped, {1, 5});
  for (const CurveChange& change : {CurveChange(line, loop), CurveChange(loop, line)}) {
    EXPECT_EQ(change.shift(0.0).value, Vector3d::Zero());
    EXPECT_EQ(change.shift(change.curve().length()).value, Vector3d::Zero());
  }
  expect_onto(CurveChange(line, loop), loop);
  expect_onto(CurveChange(loop, line), line);
}

TEST(CurveChange, EndsMayMove) {
  const FieldCurve curve = FieldCurve::through({{0, 0, 0}, {4, 0, 0}}),
                   other = FieldCurve::through({{0, 0, 0}, {4, 1, 0}});
  const CurveChange change(curve, other);
  EXPECT_EQ(change.shift(0.0).value, Vector3d::Zero());
  EXPECT_LT((change.shift(4.0).value - Vector3d(0, 1, 0)).norm(), 1e-14);
}

}  // namespace
}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/nurbs_curve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "network/curves/conics.h"
#include "network/curves/curve_pieces.h"
#include "random_values.h"

namespace hull::network {
namespace {

using hull::testing::random_vector;
using hull::testing::uniform;

NurbsCurve random_curve(std::mt19937& random, int degree) {
  const int count = degree + 1 + static_cast<int>(random() % 6);
  Points3 points(count, 3);
  Eigen::VectorXd weights(count);
  for (int i = 0; i < count; ++i) {
    points.row(i) = random_vector(random);
    weights[i] = uniform(random, 0.3, 3.0);
  }
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int i = degree + 1; i < count; ++i)
    knots.push_back(knots.back() + uniform(random, 0.2, 1.0));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, knots.back() + 0.5);
  return {degree, knots, points, weights};
}

// A quotient of sums over the splines, each by itself.
Vector3d by_definition(const NurbsCurve& curve, double t) {
  const std::function<double(int, int)> spline = [&](int i, int p) -> double {
    const auto k = [&](int n) { return curve.knots()[static_cast<std::size_t>(n)]; };
    if (p == 0) return k(i) <= t && t < k(i + 1) ? 1.0 : 0.0;
    const double a = k(i + p) - k(i), b = k(i + p + 1) - k(i + 1);
    return (a > 0.0 ? (t - k(i)) / a * spline(i, p - 1) : 0.0) +
           (b > 0.0 ? (k(i + p + 1) - t) / b * spline(i + 1, p - 1) : 0.0);
  };
  Vector3d above = Vector3d::Zero();
  double below = 0.0;
  for (int i = 0; i < curve.points().rows(); ++i) {
    const double share = spline(i, curve.degree()) * curve.weights()[i];
    above += share * curve.points().row(i).transpose();
    below += share;
  }
  return above / below;
}

TEST(NurbsCurve, IsTheQuotientOfSumsOverTheSplines) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const NurbsCurve curve = random_curve(random, 1 + trial % 5);
    const double t = uniform(random, curve.begin(), curve.end());
    EXPECT_LT((curve.point(t) - by_definition(curve, t)).norm(), 1e-14);
  }
}

TEST(NurbsCurve, DerivativesAgreeWithDifferences) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const NurbsCurve curve = random_curve(random, 1 + trial % 5);
    const double h = 1e-5;
    const double t = uniform(random, curve.begin() + h, curve.end() - h);
    bool is_at_knot = false;
    for (double knot : curve.knots()) is_at_knot |= std::abs(knot - t) <= h;
    if (is_at_knot) continue;
    const Points3 jet = curve.evaluate(t, 3);
    const Points3 above = curve.evaluate(t + h, 3), below = curve.evaluate(t - h, 3);
    for (int order = 0; order < 3; ++order) {
      const Vector3d slope = (above.row(order) - below.row(order)) / (2.0 * h);
      const double scale = 1.0 + jet.rowwise().norm().maxCoeff();
      EXPECT_LT((slope - jet.row(order + 1).transpose()).norm(), 1e-5 * scale * scale);
    }
  }
}

TEST(NurbsCurve, ReversedItRunsTheOtherWay) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const NurbsCurve curve = random_curve(random, 1 + trial % 5);
    const double t = uniform(random, curve.begin(), curve.end());
    const NurbsCurve other = curve.reversed();
    EXPECT_LT((other.point(curve.begin() + curve.end() - t) - curve.point(t)).norm(), 1e-13);
  }
}

TEST(NurbsCurve, NoPointIsNearerThanTheNearest) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const NurbsCurve curve = random_curve(random, 1 + trial % 5);
    const Vector3d place = random_vector(random);
    const double least = (curve.point(curve.nearest_parameter(place)) - place).norm();
    for (int i = 0; i <= 1000; ++i) {
      const double t = curve.begin() + (curve.end() - curve.begin()) * i / 1000.0;
      ASSERT_LE(least, (curve.point(t) - place).norm() + 1e-12);
    }
  }
}

TEST(NurbsCurve, PiecesAndTheirHalvesAreTheCurve) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const NurbsCurve curve = random_curve(random, 1 + trial % 5);
    std::vector<CurvePiece> pieces = pieces_of(curve);
    EXPECT_EQ(pieces.front().low, curve.begin());
    EXPECT_EQ(pieces.back().high, curve.end());
    for (const CurvePiece& piece : std::vector<CurvePiece>(pieces)) {
      CurvePiece first, second;
      piece.split(first, second);
      pieces.push_back(first);
      pieces.push_back(second);
    }
    for (const CurvePiece& piece : pieces) {
      const auto first = piece.points.row(0), last = piece.points.row(piece.points.rows() - 1);
      const Vector3d start = first.head<3>().transpose() / first[3];
      const Vector3d end = last.head<3>().transpose() / last[3];
      EXPECT_LT((start - curve.point(piece.low)).norm(), 1e-13);
      EXPECT_LT((end - curve.point(piece.high)).norm(), 1e-13);
      const Vector3d inside = curve.point(piece.low + 0.3 * (piece.high - piece.low));
      EXPECT_LT(piece.box().exteriorDistance(inside), 1e-13);
    }
  }
}

TEST(NurbsCurve, WhatIsNoCurveIsRefused) {
  const Points3 points = Points3::Random(4, 3);
  EXPECT_THROW(NurbsCurve(3, {0, 0, 0, 0, 1, 1, 1}, points), std::invalid_argument);
  EXPECT_THROW(NurbsCurve(3, {0, 0, 0, 1, 1, 1, 1, 1}, points), std::invalid_argument);
  EXPECT_THROW(NurbsCurve(3, {1, 1, 1, 1, 0, 0, 0, 0}, points), std::invalid_argument);
  EXPECT_THROW(NurbsCurve(3, {0, 0, 0, 0, 1, 1, 1, 1}, points, Eigen::VectorXd::Zero(4)),
               std::invalid_argument);
  EXPECT_THROW(NurbsCurve(0, {0, 1}, points.topRows(1)), std::invalid_argument);
}

double radius_error(const NurbsCurve& arc, const Vector3d& centre, double radius) {
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = arc.begin() + (arc.end() - arc.begin()) * i / 1000.0;
    worst = std::max(worst, std::abs((arc.point(t) - centre).norm() / radius - 1.0));
  }
  return worst;
}

TEST(Conics, ACircleIsOneToRounding) {
  // Of whatever length, up to nearly the whole.
  for (double angle : {0.01, 0.5, 1.5707963267948966, 2.0, 3.14, 4.0, 6.0, 6.28}) {
    const auto at = [](double a) { return Vector3d(std::cos(a), std::sin(a), 0.0); };
    const NurbsCurve arc = arc_through(at(0.0), at(0.5 * angle), at(angle));
    // Points near one another tell of the centre by their rounding only.
    const double told =
        std::max({1.0, 0.1 / (angle * angle), 0.1 / (2.0 * std::numbers::pi - angle)});
    EXPECT_LT(radius_error(arc, Vector3d::Zero(), 1.0), 2e-15 * told) << angle;
  }
  const NurbsCurve quarter = conic_arc({1, 0, 0}, {1, 1, 0}, {0, 1, 0}, std::sqrt(0.5));
  EXPECT_LT(radius_error(quarter, Vector3d::Zero(), 1.0), 1e-15);
}

TEST(Conics, AnArcLeavesInItsDirection) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d start = random_vector(random), end = random_vector(random);
    const Vector3d direction = random_vector(random).normalized();
    const NurbsCurve arc = arc_from_tangent(start, direction, end);
    const Vector3d tangent = arc.evaluate(arc.begin(), 1).row(1).transpose().normalized();
    EXPECT_LT((tangent - direction).norm(), 1e-11);
    EXPECT_EQ((arc.point(arc.begin()) - start).norm(), 0.0);
    EXPECT_LT((arc.point(arc.end()) - end).norm(), 1e-15);
  }
}

TEST(Conics, FullnessTellsEllipseParabolaAndHyperbola) {
  // Between (1, 0) and (0, 1) with tangents upright and level: (x - 1)(y - 1) = k (x + y - 1)², by
  // the line through the ends and the two tangents (Liming's form).
  for (double fullness : {0.2, 0.9, 1.0, 1.5, 8.0}) {
    const NurbsCurve arc = conic_arc({1, 0, 0}, {1, 1, 0}, {0, 1, 0}, fullness);
    const Vector3d shoulder = arc.point(0.5);
    EXPECT_NEAR((shoulder - Vector3d(0.5, 0.5, 0.0)).norm() / (Vector3d(1, 1, 0) - shoulder).norm(),
                fullness, 1e-13 * (1.0 + fullness * fullness));
    const auto product = [](const Vector3d& p) { return (p.x() - 1.0) * (p.y() - 1.0); };
    const auto chord = [](const Vector3d& p) { return p.x() + p.y() - 1.0; };
    const double k = product(shoulder) / std::pow(chord(shoulder), 2);
    for (int i = 1; i < 20; ++i) {
      const Vector3d p = arc.point(i / 20.0);
      EXPECT_NEAR(product(p), k * std::pow(chord(p), 2), 1e-14);
    }
    // The discriminant of (1 - 2k) xy - k x² - k y² + …: below zero for ellipses.
    const double discriminant = std::pow(1.0 - 2.0 * k, 2) - 4.0 * k * k;
    EXPECT_EQ(fullness < 1.0, discriminant < -1e-12);
    EXPECT_EQ(fullness > 1.0, discriminant > 1e-12);
  }
}

TEST(Conics, WhatMakesNoneIsRefused) {
  EXPECT_THROW(arc_through({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), std::invalid_argument);
  EXPECT_THROW(arc_through({0, 0, 0}, {1, 0, 0}, {1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(arc_from_tangent({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), std::invalid_argument);
  EXPECT_THROW(arc_from_tangent({0, 0, 0}, {0, 1, 0}, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(conic_arc({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, 1.0), std::invalid_argument);
  EXPECT_THROW(conic_arc({0, 0, 0}, {1, 1, 0}, {2, 0, 0}, 0.0), std::invalid_argument);
  EXPECT_THROW(conic_arc({0, 0, 0}, {1, std::nan(""), 0}, {2, 0, 0}, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/network_curve.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "random_values.h"

namespace hull::network {
namespace {

using Kind = EndCondition::Kind;

constexpr double kTolerance = 1e-3;

CurveDefinition wave(const std::string& name, int count = 9) {
  CurveDefinition curve;
  curve.name = name;
  for (int i = 0; i < count; ++i) {
    const double t = 0.7 * i;
    curve.points.emplace_back(t, std::sin(t), 0.3 * std::cos(0.5 * t));
  }
  return curve;
}

std::string refusal(const std::vector<CurveDefinition>& definitions) {
  try {
    network_curve_shapes(definitions, kTolerance);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

CurveShape shape_of(const CurveDefinition& definition) {
  return network_curve_shapes({definition}, kTolerance).front();
}

TEST(NetworkCurve, MeetsItsPointsOrTheDeviation) {
  CurveDefinition curve = wave("A");
  for (const Vector3d& point : curve.points) {
    const NurbsCurve piece = shape_of(curve).pieces.front();
    EXPECT_LT((piece.point(piece.nearest_parameter(point)) - point).norm(), 1e-12);
  }
  std::mt19937 random(7);
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
    curve.points[i] += 0.05 * testing::random_vector(random);
  }
  curve.deviation = 0.01;
  const CurveShape smooth = shape_of(curve);
  EXPECT_NEAR(smooth.error, 1e-4 * 9.0, 1e-12);
  EXPECT_LT((smooth.pieces.front().point(0.0) - curve.points.front()).norm(), 1e-14);
}

TEST(NetworkCurve, KnucklesAreMetAndPart) {
  CurveDefinition curve = wave("A");
  curve.knuckles = {3, 4};
  const CurveShape shape = shape_of(curve);
  ASSERT_EQ(shape.pieces.size(), 3u);
  EXPECT_EQ(shape.pieces[1].degree(), 1);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector3d knuckle = curve.points[3 + k];
    EXPECT_LT((shape.pieces[k].point(shape.pieces[k].end()) - knuckle).norm(), 1e-14);
    EXPECT_LT((shape.pieces[k + 1].point(0.0) - knuckle).norm(), 1e-14);
  }
}

TEST(NetworkCurve, EndConditionsAreExact) {
  for (int count : {2, 3, 4, 9}) {
    for (Kind start : {Kind::kFree, Kind::kTangent, Kind::kStraight}) {
      for (Kind end : {Kind::kFree, Kind::kTangent, Kind::kStraight}) {
        CurveDefinition curve = wave("A", count);
        const Vector3d direction(1.0, 0.4, -0.2);
        curve.start = {start, direction, -1};
        curve.end = {end, direction, -1};
        const NurbsCurve piece = shape_of(curve).pieces.front();
        for (bool is_start : {true, false}) {
          const Points3 jet = piece.evaluate(is_start ? piece.begin() : piece.end(), 2);
          const Kind kind = is_start ? start : end;
          const Vector3d d1 = jet.row(1), d2 = jet.row(2);
          if (kind == Kind::kTangent) {
            EXPECT_LT((d1.normalized() - direction.normalized()).norm(), 1e-13);
          }
          // Three conditions make a parabola, which bends everywhere.
          const int extra = (start != Kind::kFree) + (end != Kind::kFree);
          if (kind == Kind::kStraight && count + extra != 3) {
            EXPECT_LT(d2.norm(), 1e-12);
          }
          EXPECT_LT(
              (jet.row(0).transpose() - (is_start ? curve.points.front() : curve.points.back()))
                  .norm(),
              1e-14);
        }
      }
    }
  }
}

// Slaves of slaves, in whatever order they are given.
TEST(NetworkCurve, SlavesGoOnAsTheirMasters) {
  for (Kind kind : {Kind::kSlaveTangent, Kind::kSlaveCurvature}) {
    for (int count : {2, 3, 4, 9}) {
      const CurveDefinition master = wave("master");
      CurveDefinition slave = wave("slave", count), grandchild = wave("grandchild", count);
      const Vector3d end = master.points.back();
      for (Vector3d& point : slave.points)
        point = end + Vector3d(point.x(), 0.2 * point.x() * point.x(), 0.1 * point.z() - 0.03);
      slave.start = {kind, Vector3d::Zero(), 2};
      // It ends where the other begins: the other way round.
      const Vector3d origin = grandchild.points.front();
      for (Vector3d& point : grandchild.points)
        point = slave.points.front() - 0.5 * (point - origin);
      std::reverse(grandchild.points.begin(), grandchild.points.end());
      grandchild.end = {kind, Vector3d::Zero(), 1};
      const auto shapes = network_curve_shapes({grandchild, slave, master}, kTolerance);
      const NurbsCurve &last = shapes[0].pieces[0], &middle = shapes[1].pieces[0],
                       &first = shapes[2].pieces[0];
      const auto unit = [](const NurbsCurve& c, double t) -> Vector3d {
        return c.evaluate(t, 1).row(1).transpose().normalized();
      };
      const auto curvature = [](const NurbsCurve& c, double t) -> Vector3d {
        const Points3 jet = c.evaluate(t, 2);
        const Vector3d d1 = jet.row(1), d2 = jet.row(2);
        return (d2 - d2.dot(d1) / d1.squaredNorm() * d1) / d1.squaredNorm();
      };
      EXPECT_LT((unit(middle, 0.0) - unit(first, first.end())).norm(), 1e-12);
      EXPECT_LT((unit(last, last.end()) - unit(middle, 0.0)).norm(), 1e-12);
      if (kind == Kind::kSlaveCurvature) {
        EXPECT_LT((curvature(middle, 0.0) - curvature(first, first.end())).norm(), 1e-9) << count;
        EXPECT_LT((curvature(last, last.end()) - curvature(middle, 0.0)).norm(), 1e-9) << count;
      }
    }
  }
}

TEST(NetworkCurve, SlavesInACircleAreNamed) {
  CurveDefinition a = wave("A"), b = wave("B"), c = wave("C");
  a.start = {Kind::kSlaveTangent, Vector3d::Zero(), 1};
  b.end = {Kind::kSlaveTangent, Vector3d::Zero(), 2};
  c.start = {Kind::kSlaveCurvature, Vector3d::Zero(), 0};
  EXPECT_EQ(refusal({a, b, c}),
            "Curves are slaves of one another in a circle: A, slave of B, slave of C, slave of A. "
            "Give one of them an end of its own.");
  c.start = {Kind::kSlaveTangent, Vector3d::Zero(), 2};
  EXPECT_NE(refusal({a, b, c}).find("in a circle: C, slave of C."), std::string::npos);
  c.start.master = 17;
  EXPECT_EQ(refusal({a, b, c}), "The master of curve C is not there.");
}

TEST(NetworkCurve, LongChainsOfSlavesAreSolved) {
  std::vector<CurveDefinition> chain;
  for (int i = 0; i < 3000; ++i) {
    CurveDefinition curve = wave("curve " + std::to_string(i), 2);
    const Vector3d back = i == 0 ? Vector3d(0, 0, 0) : chain.back().points[1];
    curve.points = {back, back + Vector3d(1.0, 0.1 * (i % 3), 0.0)};
    if (i + 1 < 3000) curve.end = {Kind::kSlaveTangent, Vector3d::Zero(), i + 1};
    chain.push_back(curve);
  }
  EXPECT_EQ(network_curve_shapes(chain, kTolerance).size(), 3000u);
}

TEST(NetworkCurve, APlaneIsKept) {
  CurveDefinition curve = wave("A");
  for (Vector3d& point : curve.points) point.z() = 2.0;
  curve.plane = CarrierPlane{{0, 0, 2}, 4.0};
  curve.start = {Kind::kTangent, {1.0, 0.0, 5.0}, -1};
  const NurbsCurve piece = shape_of(curve).pieces.front();
  EXPECT_LT((piece.points().col(2).array() - 2.0).abs().maxCoeff(), 1e-13);
  EXPECT_LT(std::abs(piece.evaluate(0.0, 1)(1, 1)), 1e-13);
  curve.points[4].z() += 0.01;
  EXPECT_EQ(refusal({curve}), "Curve A: point 4 is 10 mm off its plane.");
  curve.points[4].z() = 2.0011;
  EXPECT_EQ(refusal({curve}), "Curve A: point 4 is 1.1 mm off its plane.");
  curve = wave("A");
  curve.plane = CarrierPlane{{0, 0, 0}, 4.0};
  EXPECT_EQ(refusal({curve}), "Curve A: its plane is none.");
}

TEST(NetworkCurve, SimpleCurvesAreExact) {
  CurveDefinition arc = wave("arc", 2);
  arc.kind = CurveDefinition::Kind::kArc;
  arc.points = {{1, 0, 0}, {0, 1, 0}};
  arc.start = {Kind::kTangent, {0, 1, 0}, -1};
  const NurbsCurve circle = shape_of(arc).pieces.front();
  EXPECT_NEAR(circle.point(0.37).norm(), 1.0, 1e-15);
  arc.kind = CurveDefinition::Kind::kConic;
  arc.end = {Kind::kTangent, {-1, 0, 0}, -1};
  arc.fullness = std::sqrt(0.5);
  EXPECT_NEAR(shape_of(arc).pieces.front().point(0.37).norm(), 1.0, 1e-15);
  arc.kind = CurveDefinition::Kind::kLine;
  EXPECT_EQ(shape_of(arc).pieces.front().point(0.5), Vector3d(0.5, 0.5, 0.0));
}

TEST(NetworkCurve, WhatCannotBeIsNamed) {
  CurveDefinition curve = wave("Stem", 3);
  curve.kind = CurveDefinition::Kind::kLine;
  EXPECT_EQ(refusal({curve}), "Curve Stem: a straight line has two points.");
  curve.kind = CurveDefinition::Kind::kConic;
  EXPECT_EQ(refusal({curve}), "Curve Stem: a conic has two points and directions at both.");
  curve.kind = CurveDefinition::Kind::kArc;
  curve.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(refusal({curve}),
            "Curve Stem: The three points of a circular arc are on a straight line.");
  curve = wave("Stem");
  curve.points[3] = curve.points[2];
  EXPECT_NE(refusal({curve}).find("Curve Stem: Points 2 and 3"), std::string::npos);
  curve = wave("Stem", 1);
  EXPECT_EQ(refusal({curve}), "Curve Stem: it needs two points or more.");
  curve = wave("Stem");
  curve.knuckles = {3, 2};
  EXPECT_EQ(refusal({curve}), "Curve Stem: knuckles are points between its ends, in order.");
  curve = wave("Stem");
  curve.start = {Kind::kTangent, {0, 0, 0}, -1};
  EXPECT_EQ(refusal({curve}), "Curve Stem: a direction at its end is none.");
  curve = wave("Stem");
  curve.start = {Kind::kSlaveTangent, Vector3d::Zero(), 1};
  CurveDefinition far = wave("Keel");
  for (Vector3d& point : far.points) point.z() += 1.0;
  EXPECT_EQ(refusal({curve, far}), "Curve Stem: its start is 1.000 m from Keel, its master.");
}

TEST(NetworkCurve, AConicsDirectionsThatMissOneAnotherAreNamed) {
  CurveDefinition conic = wave("Bow", 2);
  conic.kind = CurveDefinition::Kind::kConic;
  conic.points = {{0, 0, 0}, {1, 1, 0.4}};
  conic.start = {Kind::kTangent, {1, 0, 0}, -1};
  conic.end = {Kind::kTangent, {0, 1, 0}, -1};
  EXPECT_EQ(refusal({conic}),
            "Curve Bow: the lines along the directions at its ends miss one another by 400 mm: "
            "give directions in one plane with both points.");
  // As far as points may be apart that are one.
  conic.points[1].z() = 0.9 * kTolerance;
  EXPECT_EQ(refusal({conic}), "");
}

}  // namespace
}  // namespace hull::network

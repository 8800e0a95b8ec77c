// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_splines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "polylines.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

// ∮ x × dx / 2 along a spline: Gauss' rule of three points is exact for the cubics' product.
double signed_area(const surface::CubicSpline& spline, const Vector3d& normal) {
  double area = 0.0;
  const double reach = std::sqrt(0.15), nodes[] = {0.5 - reach, 0.5, 0.5 + reach};
  const double weights[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const std::vector<double>& k = spline.knots();
  for (std::size_t i = 3; i + 4 < k.size(); ++i) {
    for (int g = 0; g < 3; ++g) {
      const double h = k[i + 1] - k[i];
      const surface::CurveJet jet = spline.evaluate(k[i] + h * nodes[g], 1);
      area += 0.5 * weights[g] * h * normal.dot(jet.point.cross(jet.d1));
    }
  }
  return area;
}

TEST(SectionSplines, OfABoxAreItsSides) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  const std::vector<SectionSplines> branches =
      section_splines(box, plane_across(Axis::kZ, 1.3), 1e-6);
  ASSERT_EQ(branches.size(), 1u);
  EXPECT_TRUE(branches[0].closed);
  ASSERT_EQ(branches[0].splines.size(), 4u);
  double area = 0.0;
  for (const SectionSpline& s : branches[0].splines) {
    EXPECT_FALSE(s.closed);
    EXPECT_EQ(s.curve.points().size(), 4u);
    area += signed_area(s.curve, Vector3d::UnitZ());
  }
  EXPECT_NEAR(area, 40.0, 1e-12);
}

// Of random bodies: within the tolerance, in the plane, joined, with two derivatives.
TEST(SectionSplines, FollowSections) {
  constexpr unsigned kSeed = 71;
  constexpr double kTolerance = 1e-4;
  std::mt19937 random(kSeed);
  std::normal_distribution<double> normal;
  std::size_t fitted = 0, sampled = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << ", trial " << trial);
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const Vector3d n = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Plane plane{n, n.dot(surface.position(0, 0.31, 0.57))};
    const std::vector<SectionSplines> branches = section_splines(surface, plane, kTolerance);
    const std::vector<SectionCurve> fine = section(surface, plane, 1e-2 * kTolerance);
    ASSERT_EQ(branches.size(), fine.size());
    for (std::size_t b = 0; b < branches.size(); ++b) {
      EXPECT_EQ(branches[b].closed, fine[b].closed);
      std::vector<Vector3d> trace;
      for (const SectionSpline& s : branches[b].splines) {
        EXPECT_LE(s.largest_distance, kTolerance);
        fitted += s.curve.points().size();
        for (const Vector3d& p : s.curve.points()) {
          EXPECT_NEAR(plane.height(p), 0.0, 1e-14);
        }
        if (!trace.empty()) {
          EXPECT_LT((trace.back() - s.curve.points().front()).norm(), 1e-12);
        }
        const std::vector<double>& k = s.curve.knots();
        for (std::size_t i = 3; i + 4 < k.size(); ++i) {
          ASSERT_LT(k[i], k[i + 1]);
          for (int j = 0; j < 100; ++j) {
            trace.push_back(s.curve.evaluate(k[i] + (k[i + 1] - k[i]) * j / 100.0, 0).point);
          }
        }
        trace.push_back(s.curve.points().back());
        if (!s.closed) continue;
        const surface::CurveJet start = s.curve.evaluate(s.curve.begin(), 2);
        const surface::CurveJet end = s.curve.evaluate(s.curve.end(), 2);
        EXPECT_LT((start.point - end.point).norm(), 1e-12);
        EXPECT_LT((start.d1 - end.d1).norm(), 1e-9);
        EXPECT_LT((start.d2 - end.d2).norm(), 1e-6 * (1.0 + start.d2.norm()));
      }
      sampled += fine[b].points.size();
      for (std::size_t i = 0; i < fine[b].points.size(); i += 23) {
        double nearest = 1.0;
        for (std::size_t j = 1; j < trace.size(); ++j) {
          nearest = std::min(nearest, testing::distance(fine[b].points[i], trace[j - 1], trace[j]));
        }
        EXPECT_LE(nearest, 1.2 * kTolerance);
      }
    }
  }
  EXPECT_LT(10 * fitted, sampled);
}

TEST(SectionSplines, RefuseBadArguments) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  EXPECT_THROW(section_splines(surface, {Vector3d::UnitX(), 0.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(section_splines(surface, {Vector3d::Zero(), 0.0}, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis

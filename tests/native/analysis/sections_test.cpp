// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "analysis/immersion/hull_body.h"
#include "analysis/sections/feature_curves.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

// Signed area enclosed by closed curves in a plane z = const, from above; exact for polygons.
double enclosed_area(const std::vector<SectionCurve>& curves) {
  double area = 0.0;
  for (const SectionCurve& c : curves) {
    double twice = 0.0;
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      twice += c.points[i - 1].x() * c.points[i].y() - c.points[i].x() * c.points[i - 1].y();
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

void expect_on_plane_and_surface(const surface::LimitSurface& surface, const Plane& plane,
                                 const std::vector<SectionCurve>& curves) {
  const double tolerance = 1e-10 * surface.mesh().size();
  for (const SectionCurve& c : curves) {
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      ASSERT_LT(std::abs(plane.height(c.points[i])), tolerance);
      const Vector3d there = surface.position(c.cells[i], c.uv[i].x(), c.uv[i].y());
      ASSERT_LT((there - c.points[i]).norm(), tolerance);
    }
  }
}

TEST(Sections, OfABox) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  const std::vector<SectionCurve> curves = section(box, Axis::kZ, 1.3, 1e-3);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(curves[0].knuckles.size(), 4u);
  EXPECT_NEAR(enclosed_area(curves), 40.0, 1e-12);
}

// Of a face in the plane, the border; beyond the body nothing.
TEST(Sections, OfABoxInThePlaneOfAFace) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  for (const double z : {0.0, 3.0}) {
    const std::vector<SectionCurve> curves = section(box, Axis::kZ, z, 1e-3);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_EQ(curves[0].knuckles.size(), 4u);
    EXPECT_NEAR(enclosed_area(curves), 40.0, 1e-12);
  }
  EXPECT_TRUE(section(box, Axis::kZ, 3.5, 1e-3).empty());
}

// Over random bodies: complete loops on surface and plane, enclosing the waterplane's area.
TEST(Sections, EncloseTheWaterplane) {
  constexpr unsigned kSeed = 404;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < 40; ++trial) {
    mesh::MeshArrays arrays = trial % 2 ? testing::prism(3 + trial % 7) : testing::cube();
    testing::randomise(arrays, random, 0.2, 0.05, 0.2);
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    const Plane plane{Vector3d::UnitZ(), -0.4 + 0.02 * trial};
    const std::vector<SectionCurve> curves = section(surface, plane, 1e-6);
    expect_on_plane_and_surface(surface, plane, curves);
    for (const SectionCurve& c : curves) EXPECT_TRUE(c.closed) << "trial " << trial;
    // Chords lie within 1e-6 of the curve, so the area within about 1e-6 times its length.
    EXPECT_NEAR(enclosed_area(curves), HullBody(surface, false).immersion(plane).waterplane_area,
                2e-5)
        << "trial " << trial;
  }
}

TEST(Sections, EndOnBorders) {
  mesh::MeshArrays arrays = testing::grid(3, 3);
  for (auto& p : arrays.points) p.z() = 0.1 * p.x() * p.x() + 0.05 * p.y();
  const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  const std::vector<SectionCurve> curves = section(surface, Axis::kX, 1.4, 1e-4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].closed);
  const double ends[] = {curves[0].points.front().y(), curves[0].points.back().y()};
  EXPECT_NEAR(std::min(ends[0], ends[1]), 0.0, 1e-14);
  EXPECT_NEAR(std::max(ends[0], ends[1]), 3.0, 1e-14);
}

TEST(Sections, KeepToTheChordTolerance) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const std::vector<SectionCurve> fine = section(surface, Axis::kZ, 0.1, 1e-8);
  for (double tolerance : {1e-2, 1e-3, 1e-4}) {
    const std::vector<SectionCurve> coarse = section(surface, Axis::kZ, 0.1, tolerance);
    // Every fine point is near some chord.
    double worst = 0.0;
    for (const Vector3d& p : fine[0].points) {
      double nearest = 1.0;
      for (std::size_t i = 1; i < coarse[0].points.size(); ++i) {
        const Vector3d a = coarse[0].points[i - 1], d = coarse[0].points[i] - a;
        const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - t * d).norm());
      }
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, 1.1 * tolerance);
  }
}

// Tangents and curvatures against divided differences of points and of tangents: a thousandth
// of the points may be off, beside irregular knots, where curvature varies within their spacing.
TEST(Sections, HaveTangentsAndCurvaturesOfTheirPoints) {
  constexpr unsigned kSeed = 17;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::normal_distribution<double> normal;
  int compared = 0, off = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const Vector3d n = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Plane plane{n, n.dot(surface.position(0, 0.4, 0.7))};
    for (const SectionCurve& c : section(surface, plane, 1e-7)) {
      for (const SmoothStretch& s : smooth_stretches(c)) {
        for (int i = s.first + 2; i + 2 <= s.last; ++i) {
          const Vector3d before = c.points[i] - c.points[i - 1],
                         after = c.points[i + 1] - c.points[i];
          const double a = before.norm(), b = after.norm();
          if (a < 1e-4 || b < 1e-4) continue;
          // Of the parabola through three points, over lengths.
          const Vector3d slope = (b / a * before + a / b * after) / (a + b);
          const double t0 = std::asin(n.dot(c.tangents[i - 1].cross(c.tangents[i]))) / a;
          const double t1 = std::asin(n.dot(c.tangents[i].cross(c.tangents[i + 1]))) / b;
          const double bend = (b * t0 + a * t1) / (a + b);
          ++compared;
          off += (slope - c.tangents[i]).norm() > 1e-4 ||
                 std::abs(bend - c.curvatures[i]) > 1e-3 * (1.0 + std::abs(bend));
        }
      }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_LE(off, compared / 1000);
}

// A convex body's section runs with the body on its left and turns left, whichever way one looks.
TEST(Sections, RunWithTheBodyOnTheLeft) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  for (const double sign : {1.0, -1.0}) {
    const Vector3d n = sign * Vector3d(0.2, 0.3, 1.0).normalized();
    const std::vector<SectionCurve> curves = section(surface, Plane{n, 0.1}, 1e-5);
    ASSERT_EQ(curves.size(), 1u);
    double twice = 0.0;
    for (std::size_t i = 1; i < curves[0].points.size(); ++i) {
      twice += n.dot(curves[0].points[i - 1].cross(curves[0].points[i]));
    }
    EXPECT_GT(twice, 0.0);
    for (const double curvature : curves[0].curvatures) EXPECT_GT(curvature, 0.0);
  }
}

// Both values at a knuckle: straight sides of a box that turn.
TEST(Sections, HaveBothSidesOfKnuckles) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  const std::vector<SectionCurve> curves = section(box, Axis::kZ, 1.3, 1e-3);
  ASSERT_EQ(curves.size(), 1u);
  const SectionCurve& c = curves[0];
  EXPECT_EQ(c.knuckles.back(), static_cast<int>(c.points.size()) - 1);
  ASSERT_EQ(c.knuckle_tangents.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(c.tangents[c.knuckles[k]].dot(c.knuckle_tangents[k]), 0.0, 1e-12);
    EXPECT_NEAR(c.knuckle_curvatures[k], 0.0, 1e-12);
  }
  EXPECT_EQ(smooth_stretches(c).size(), 4u);
}

TEST(Sections, ByDiagonals) {
  const Plane plane = diagonal_plane(2.0, 0.5);
  EXPECT_NEAR(plane.height({3.0, 0.0, 2.0}), 0.0, 1e-15);
  EXPECT_NEAR(plane.height({-1.0, 1.0, 2.0 - std::tan(0.5)}), 0.0, 1e-15);
  EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-15);
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  EXPECT_EQ(section(box, plane, 1e-3).size(), 1u);
}

TEST(Sections, AtOnceAreThoseOneByOne) {
  std::mt19937 random(5);
  const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
  std::vector<Plane> planes;
  for (int k = 0; k < 12; ++k) {
    planes.push_back(plane_across(static_cast<Axis>(k % 3), 0.1 * k - 0.5));
  }
  const auto all = sections(surface, planes, {1e-4, {}});
  ASSERT_EQ(all.size(), planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const std::vector<SectionCurve> one = section(surface, planes[k], 1e-4);
    ASSERT_EQ(all[k].size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(all[k][i].points, one[i].points);
  }
}

TEST(Sections, RefuseBadArguments) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  EXPECT_THROW(section(surface, Axis::kX, NAN, 1e-3), std::invalid_argument);
  EXPECT_THROW(section(surface, Axis::kX, 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(section(surface, Plane{{1.0, 1.0, 0.0}, 0.0}, 1e-3), std::invalid_argument);
  EXPECT_THROW(section(surface, Plane{Vector3d::UnitX(), 0.0}, {1e-3, -1.0}),
               std::invalid_argument);
}

TEST(FeatureCurves, OfABoxAreItsEdges) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  const std::vector<FeatureCurve> curves = feature_curves(box, 4);
  EXPECT_EQ(curves.size(), 12u);
  double length = 0.0;
  for (const FeatureCurve& c : curves) {
    EXPECT_EQ(c.kind, surface::CreaseKind::kCrease);
    EXPECT_EQ(c.vertices.size(), 2u);
    length += (c.points.back() - c.points.front()).norm();
  }
  EXPECT_NEAR(length, 4.0 * 17.0, 1e-12);
}

TEST(FeatureCurves, CloseAndSplit) {
  mesh::MeshArrays arrays = testing::prism(6);
  for (int k = 0; k < 6; ++k) arrays.creases.push_back({k, (k + 1) % 6});
  std::vector<FeatureCurve> curves =
      feature_curves(surface::LimitSurface{mesh::ControlMesh(arrays)});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(curves[0].vertices.size(), 6u);
  EXPECT_EQ(curves[0].points.size(), 6u * 16u + 1u);
  arrays.corners = {0, 3};
  curves = feature_curves(surface::LimitSurface{mesh::ControlMesh(arrays)});
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_FALSE(curves[0].closed);
  const surface::LimitSurface sheet{mesh::ControlMesh(testing::grid(2, 2))};
  const std::vector<FeatureCurve> borders = feature_curves(sheet, 2);
  ASSERT_EQ(borders.size(), 4u);
  EXPECT_EQ(borders[0].kind, surface::CreaseKind::kBorder);
}

}  // namespace
}  // namespace hull::analysis

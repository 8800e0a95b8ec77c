// SPDX-License-Identifier: GPL-3.0-or-later
// Planes in which parts of the surface lie, or which touch it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <numbers>

#include "analysis/sections/sections.h"
#include "polylines.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

// Twice the area to the left, seen against the normal.
double signed_area(const SectionCurve& curve, const Vector3d& normal) {
  Vector3d twice = Vector3d::Zero();
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    twice += (curve.points[i - 1] - curve.points[0]).cross(curve.points[i] - curve.points[0]);
  }
  return 0.5 * twice.dot(normal);
}

// An m x n grid whose points with k < low or k > high along x are raised by quadratic ramps.
mesh::MeshArrays raised_grid(int m, int n, const std::function<double(double, double)>& height) {
  mesh::MeshArrays mesh = testing::grid(m, n);
  for (auto& p : mesh.points) p.z() = height(p.x(), p.y());
  return mesh;
}

// A flat of spans inside a smooth surface: points (2 … 5)² of a grid lie in the plane, which makes
// the spans (3 … 4)² flat, all around is above.
TEST(SectionsInThePlane, BoundAFlatRegion) {
  const mesh::MeshArrays mesh = raised_grid(
      7, 7, [](double x, double y) { return x >= 2 && x <= 5 && y >= 2 && y <= 5 ? 0.0 : 1.0; });
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  for (const double sign : {1.0, -1.0}) {
    const Plane plane{sign * Vector3d::UnitZ(), 0.0};
    const std::vector<SectionCurve> curves = section(surface, plane, 1e-3);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_EQ(curves[0].knuckles.size(), 4u);
    EXPECT_NEAR(testing::length_of(curves), 4.0, 1e-12);
  }
}

// A trough: flat along y between two ramps, open at both ends. The flat's border is four lines.
TEST(SectionsInThePlane, BoundAFlatUpToTheBorder) {
  const mesh::MeshArrays mesh =
      raised_grid(8, 3, [](double x, double) { return std::max(std::abs(x - 4.0) - 2.0, 0.0); });
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, 1e-3);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  // From x = 3 to 5: the spans whose control points 2 … 6 are flat.
  EXPECT_NEAR(testing::length_of(curves), 2.0 * 2.0 + 2.0 * 3.0, 1e-12);
}

// One side of the flat goes up, the other down: two lines, each once.
TEST(SectionsInThePlane, BoundAStepOnBothSides) {
  const mesh::MeshArrays mesh = raised_grid(8, 3, [](double x, double) {
    return x > 6.0 ? x - 6.0 : x < 2.0 ? x - 2.0 : 0.0;
  });
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, 1e-3);
  EXPECT_NEAR(testing::length_of(curves), 2.0 * 2.0 + 2.0 * 3.0, 1e-12);
}

// Single-precision noise on a flat: the outline is had with a tolerance above the noise.
TEST(SectionsInThePlane, SeeThroughNoise) {
  constexpr unsigned kSeed = 22;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> noise(-1e-6, 1e-6);
  mesh::MeshArrays mesh = raised_grid(
      7, 7, [](double x, double y) { return x >= 2 && x <= 5 && y >= 2 && y <= 5 ? 0.0 : 1.0; });
  for (auto& p : mesh.points) p.z() += noise(random);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, {1e-3, 2e-6});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_NEAR(testing::length_of(curves), 4.0, 1e-4);
}

// A keel: a crease in the plane with the surface above on both sides.
TEST(SectionsInThePlane, HaveCreasesOnce) {
  mesh::MeshArrays mesh = raised_grid(6, 4, [](double x, double) { return std::abs(x - 3.0); });
  for (int j = 0; j < 4; ++j) mesh.creases.push_back({7 * j + 3, 7 * j + 10});
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, 1e-3);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_NEAR(testing::length_of(curves), 4.0, 1e-12);
  EXPECT_TRUE(curves[0].knuckles.empty());
}

// A smooth valley whose bottom is a line between patches.
TEST(SectionsInThePlane, HaveLinesBetweenPatchesOnce) {
  // The B-spline of control heights x² - 1/3 is x².
  const mesh::MeshArrays mesh =
      raised_grid(6, 4, [](double x, double) { return (x - 3.0) * (x - 3.0) - 1.0 / 3.0; });
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, 1e-3);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(testing::length_of(curves), 4.0, 1e-12);
}

// The border of a half body in its centre plane, run through with the body on the left.
TEST(SectionsInThePlane, HaveTheBorderOfAHalfBody) {
  mesh::MeshArrays mesh = testing::grid(6, 3);
  for (auto& p : mesh.points) {
    const double y = p.y(), x = p.x() - 3.0;
    p = {p.x(), 0.5 * y * (1.0 - 0.05 * x * x), 0.3 * y * y + 0.1 * x * x};
  }
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitY(), 0.0}, 1e-4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_NEAR(std::abs(curves[0].points.front().x() - curves[0].points.back().x()), 6.0, 1e-12);
  for (std::size_t i = 0; i < curves[0].points.size(); ++i) {
    const Vector3d there =
        surface.position(curves[0].cells[i], curves[0].uv[i].x(), curves[0].uv[i].y());
    EXPECT_LT((there - curves[0].points[i]).norm(), 1e-12);
    EXPECT_NEAR(curves[0].points[i].y(), 0.0, 1e-15);
    EXPECT_NEAR(curves[0].tangents[i].norm(), 1.0, 1e-12);
  }
}

// A saddle in the plane: two lines that cross. Their four branches meet, and none is missing.
TEST(SectionsInThePlane, MeetInSaddles) {
  for (const double shift : {0.0, 0.13, 1e-9}) {
    const mesh::MeshArrays mesh = raised_grid(6, 6, [&](double x, double y) {
      const double a = x - 3.0 - shift, b = y - 3.0 - 0.7 * shift;
      return a * a - 0.8 * b * b - 0.2 / 3.0;
    });
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const std::vector<SectionCurve> curves = section(surface, {Vector3d::UnitZ(), 0.0}, 1e-4);
    EXPECT_EQ(curves.size(), 2u) << shift;
    // Ghost points beyond the borders bend the outermost spans; the middle is exact.
    for (const SectionCurve& curve : curves) {
      double nearest = 1.0;
      for (const Vector3d& p : curve.points) {
        nearest = std::min(nearest, std::hypot(p.x() - 3.0 - shift, p.y() - 3.0 - 0.7 * shift));
      }
      EXPECT_LT(nearest, 1e-4) << shift;
    }
  }
}

// The top of a bump touches the plane: nothing.
TEST(SectionsInThePlane, LeaveOutPointsOfTouch) {
  for (const double shift : {0.0, 0.21}) {
    for (const double sign : {1.0, -1.0}) {
      const mesh::MeshArrays mesh = raised_grid(6, 6, [&](double x, double y) {
        const double a = x - 3.0 - shift, b = y - 3.0 + shift;
        return sign * (a * a + 0.8 * b * b - 1.8 / 3.0);
      });
      const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
      EXPECT_TRUE(section(surface, {Vector3d::UnitZ(), 0.0}, 1e-4).empty()) << shift;
    }
  }
}

// A plane through opposite edges of a cube: diagonals of faces and edges between.
TEST(SectionsInThePlane, RunAlongEdges) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(2.0, 2.0, 2.0))};
  const Vector3d normal = Vector3d(1.0, 0.0, -1.0).normalized();
  const std::vector<SectionCurve> curves = section(box, Plane{normal, 0.0}, 1e-4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(curves[0].knuckles.size(), 4u);
  EXPECT_NEAR(signed_area(curves[0], normal), 4.0 * std::numbers::sqrt2, 1e-12);
}

}  // namespace
}  // namespace hull::analysis

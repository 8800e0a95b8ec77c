// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curvature.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "test_meshes.h"

namespace hull::surface {
namespace {

// Control heights of a quadratic a x² + b x y + c y² over a grid: cubic B-splines reproduce it but
// for a constant, so its curvature is known in closed form.
mesh::MeshArrays quadratic(double a, double b, double c) {
  mesh::MeshArrays mesh = testing::grid(7, 7);
  for (auto& p : mesh.points) {
    p.x() -= 3.5;
    p.y() -= 3.5;
    p.z() = a * p.x() * p.x() + b * p.x() * p.y() + c * p.y() * p.y();
  }
  return mesh;
}

TEST(Curvature, OfQuadraticGraphs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-0.3, 0.3);
  for (int trial = 0; trial < 50; ++trial) {
    const double a = unit(random), b = unit(random), c = unit(random);
    const LimitSurface surface{mesh::ControlMesh(quadratic(a, b, c))};
    // The cells of the face in the middle, which no border reaches.
    const int cell = 4 * (3 * 7 + 3) + trial % 4;
    const double u = 0.35 + unit(random), v = 0.35 + unit(random);
    const Vector3d p = surface.position(cell, u, v);
    const double fx = 2.0 * a * p.x() + b * p.y(), fy = b * p.x() + 2.0 * c * p.y();
    const double w = 1.0 + fx * fx + fy * fy;
    // Of a graph z = f(x, y), normal up: a bowl is hollow towards it, hence the sign.
    const double gaussian = (4.0 * a * c - b * b) / (w * w);
    const double mean =
        -((1.0 + fy * fy) * 2.0 * a - 2.0 * fx * fy * b + (1.0 + fx * fx) * 2.0 * c) /
        (2.0 * std::pow(w, 1.5));
    const Curvature k = curvature(surface, cell, u, v);
    ASSERT_TRUE(k.defined);
    EXPECT_FALSE(k.at_irregular_knot);
    EXPECT_NEAR(k.gaussian(), gaussian, 1e-12);
    EXPECT_NEAR(k.mean(), mean, 1e-12);
    EXPECT_NEAR(k.maximum_direction.dot(k.minimum_direction), 0.0, 1e-12);
    EXPECT_NEAR(k.maximum_direction.norm(), 1.0, 1e-12);
    EXPECT_LT(std::abs(surface.normal(cell, u, v).dot(k.maximum_direction)), 1e-12);
  }
}

// Turned, moved, and scaled: curvature goes with the reciprocal of lengths.
TEST(Curvature, IsGeometric) {
  std::mt19937 random(6);
  const Eigen::AngleAxisd turn(1.1, Vector3d(0.2, -1.0, 0.4).normalized());
  for (int trial = 0; trial < 20; ++trial) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 8);
    mesh::MeshArrays moved = arrays;
    for (auto& p : moved.points) p = 2.0 * (turn * p) + Vector3d(5.0, 6.0, 7.0);
    const LimitSurface a{mesh::ControlMesh(arrays)}, b{mesh::ControlMesh(moved)};
    for (int cell = 0; cell < a.cell_count(); ++cell) {
      const Curvature k = curvature(a, cell, 0.3, 0.4), l = curvature(b, cell, 0.3, 0.4);
      const double scale = 1.0 + std::abs(k.maximum) + std::abs(k.minimum);
      ASSERT_NEAR(k.maximum, 2.0 * l.maximum, 1e-9 * scale);
      ASSERT_NEAR(k.minimum, 2.0 * l.minimum, 1e-9 * scale);
    }
  }
}

TEST(Curvature, OfAConvexBodyIsPositive) {
  const LimitSurface surface{mesh::ControlMesh(testing::cube())};
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    EXPECT_GT(curvature(surface, cell, 0.5, 0.5).minimum, 0.0);
  }
}

TEST(Curvature, IsFlaggedAtIrregularKnots) {
  const LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const Curvature knot = curvature(surface, 0, 0.0, 0.0);
  EXPECT_TRUE(knot.at_irregular_knot);
  EXPECT_TRUE(knot.defined);
  EXPECT_EQ(knot.maximum, curvature(surface, 0, kKnotOffset, kKnotOffset).maximum);
  EXPECT_FALSE(curvature(surface, 0, 1.0, 1.0).at_irregular_knot);
  mesh::MeshArrays cone = testing::fan(5);
  cone.corners = {0};
  EXPECT_TRUE(curvature(LimitSurface{mesh::ControlMesh(cone)}, 0, 0.0, 0.0).at_irregular_knot);
}

}  // namespace
}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/per_cell/per_cell.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "conversion/quality/measure_quality.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

mesh::ControlMesh wavy_grid(int m, int n) {
  mesh::MeshArrays mesh = testing::grid(m, n);
  for (Vector3d& p : mesh.points) p.z() = std::sin(1.3 * p.x()) * std::cos(0.9 * p.y());
  return mesh::ControlMesh(mesh);
}

mesh::ControlMesh cube() { return mesh::ControlMesh(testing::cube()); }
mesh::ControlMesh fan(int n) { return mesh::ControlMesh(testing::fan(n)); }

TEST(FitPerCell, ReproducesRegularCells) {
  const surface::LimitSurface surface(wavy_grid(4, 3));
  for (int n : {4, 5, 7}) {
    const PatchSet set = fit_per_cell(surface, n);
    ASSERT_NO_THROW(set.check());
    ASSERT_EQ(static_cast<int>(set.patches.size()), surface.cell_count());
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      EXPECT_EQ(set.patches[cell].cell, cell);
      EXPECT_EQ(set.blocks[cell].sides, (std::vector<int>{4 * cell}));
      for (double u : {0.0, 0.31, 1.0}) {
        for (double v : {0.0, 0.77, 1.0}) {
          EXPECT_LT((set.patches[cell].position(u, v) - surface.position(cell, u, v)).norm(),
                    1e-13 * surface.mesh().size());
        }
      }
    }
  }
}

TEST(FitPerCell, SharesBordersBitForBitAndInterpolatesCorners) {
  for (const mesh::ControlMesh& mesh :
       {cube(), fan(5), fan(3), mesh::ControlMesh(testing::creased_box(3, 2, 1))}) {
    const surface::LimitSurface surface(mesh);
    const PatchSet set = fit_per_cell(surface, 5);
    ASSERT_NO_THROW(set.check());  // asserts equality of shared sides and corners
    EXPECT_EQ(set.edge_count, surface.cells().edge_count());
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      for (double u : {0.0, 1.0}) {
        for (double v : {0.0, 1.0}) {
          EXPECT_LT((set.patches[cell].position(u, v) - surface.position(cell, u, v)).norm(),
                    1e-13 * mesh.size());
        }
      }
    }
  }
}

TEST(FitPerCell, MoreControlPointsComeCloser) {
  const surface::LimitSurface surface(fan(5));
  double last = 1e300;
  for (int n : {4, 5, 6, 7, 12}) {
    const double rms = measure_quality(surface, fit_per_cell(surface, n)).rms_distance;
    EXPECT_LT(rms, last) << n;
    last = rms;
  }
}

TEST(FitPerCell, MovesWithTheMesh) {
  const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, 3).normalized());
  const Vector3d shift(4, -5, 6);
  const mesh::ControlMesh mesh = fan(5);
  std::vector<Vector3d> moved;
  for (const Vector3d& point : mesh.points()) moved.push_back(turn * point + shift);
  const PatchSet here = fit_per_cell(surface::LimitSurface(mesh), 5);
  const PatchSet there = fit_per_cell(surface::LimitSurface(mesh.with_points(moved)), 5);
  for (size_t p = 0; p < here.patches.size(); ++p) {
    for (size_t i = 0; i < here.patches[p].control_points.size(); ++i) {
      const Vector3d expected = turn * here.patches[p].control_points[i] + shift;
      EXPECT_LT((there.patches[p].control_points[i] - expected).norm(), 1e-12);
    }
  }
}

TEST(FitPerCell, TakesCellsWithoutWidth) {
  mesh::ControlMesh mesh = wavy_grid(4, 3);
  std::vector<Vector3d> points = mesh.points();
  for (int j = 0; j <= 3; ++j) points[j * 5 + 2] = points[j * 5 + 1];  // a column of no width
  points[0] = points[1];                                               // a side of no length
  const surface::LimitSurface surface(mesh.with_points(points));
  const PatchSet set = fit_per_cell(surface, 5);
  ASSERT_NO_THROW(set.check());
  EXPECT_LT(measure_quality(surface, set).distance.value, 1e-13 * mesh.size());
}

TEST(FitPerCell, RefusesOtherNumbersOfControlPoints) {
  const surface::LimitSurface surface(cube());
  EXPECT_THROW(fit_per_cell(surface, 3), std::invalid_argument);
  EXPECT_THROW(fit_per_cell(surface, 17), std::invalid_argument);
}

}  // namespace
}  // namespace hull::conversion

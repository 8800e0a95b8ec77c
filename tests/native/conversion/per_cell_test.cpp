// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/per_cell.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "test_meshes.h"

namespace hull {
namespace {

ControlMesh wavy_grid(int m, int n) {
  MeshArrays mesh = testing::grid(m, n);
  for (Vector3d& p : mesh.points) p.z() = std::sin(1.3 * p.x()) * std::cos(0.9 * p.y());
  return ControlMesh(mesh);
}

ControlMesh cube() { return ControlMesh(testing::cube()); }
ControlMesh fan(int n) { return ControlMesh(testing::fan(n)); }

TEST(FitPerCell, ReproducesRegularCells) {
  const LimitSurface surface(wavy_grid(4, 3));
  for (int n : {4, 5, 7}) {
    const PatchSet set = fit_per_cell(surface, n);
    ASSERT_NO_THROW(set.check());
    ASSERT_EQ(static_cast<int>(set.patches.size()), surface.cell_count());
    EXPECT_LT(set.report.largest_distance, 1e-13 * surface.mesh().size()) << n;
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
  for (const ControlMesh& mesh :
       {cube(), fan(5), fan(3), ControlMesh(testing::creased_box(3, 2, 1))}) {
    const LimitSurface surface(mesh);
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

// The distance from a point to one cell, found without the gauge: the closest of a grid, refined
// around the best sample.
double brute_distance(const LimitSurface& surface, int cell, const Vector3d& point) {
  double best = 1e300, best_u = 0.5, best_v = 0.5;
  for (double step = 1.0 / 8; step > 1e-7; step /= 3) {
    const double u = best_u, v = best_v;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double at_u = std::clamp(u + i * step, 0.0, 1.0);
        const double at_v = std::clamp(v + j * step, 0.0, 1.0);
        const double distance = (surface.position(cell, at_u, at_v) - point).norm();
        if (distance >= best) continue;
        best = distance;
        best_u = at_u;
        best_v = at_v;
      }
    }
  }
  return best;
}

// The closest point may lie in another cell.
double brute_distance(const LimitSurface& surface, const Vector3d& point) {
  double best = 1e300;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    const Vector3d middle = surface.position(cell, 0.5, 0.5);
    if ((middle - point).norm() > 0.25 * surface.mesh().size()) continue;
    best = std::min(best, brute_distance(surface, cell, point));
  }
  return best;
}

// The report's samples differ from those here, so "never less" holds up to what lies between its
// samples: a twentieth.
TEST(FitPerCell, ReportBoundsAnIndependentMeasurement) {
  constexpr unsigned kSeed = 11;
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> parameter(0.0, 1.0);
  for (const ControlMesh& mesh : {cube(), fan(5)}) {
    const LimitSurface surface(mesh);
    const PatchSet set = fit_per_cell(surface, 5);
    double largest = 0.0, at_equal_parameters = 0.0;
    for (size_t p = 0; p < set.patches.size(); p += 3) {
      const BSplinePatch& patch = set.patches[p];
      for (int i = 0; i < 4; ++i) {
        // Half of them near the borders and corners, where the patches are furthest off.
        const double bend = i % 2 == 0 ? 1.0 : 4.0;
        const double u = std::pow(parameter(random), bend), v = std::pow(parameter(random), bend);
        const Vector3d point = patch.position(u, v);
        largest = std::max(largest, brute_distance(surface, point));
        at_equal_parameters =
            std::max(at_equal_parameters, (point - surface.position(patch.cell, u, v)).norm());
      }
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_LE(largest, 1.05 * set.report.largest_distance);
    EXPECT_LT(set.report.largest_distance, at_equal_parameters);  // irregular corners slide
    EXPECT_LT(set.report.rms_distance, set.report.largest_distance);
    EXPECT_EQ(*std::ranges::max_element(set.report.cell_largest), set.report.largest_distance);
    EXPECT_EQ(set.report.cell_largest[set.report.cell], set.report.largest_distance);
  }
}

TEST(FitPerCell, MoreControlPointsComeCloser) {
  const LimitSurface surface(fan(5));
  double last = 1e300;
  for (int n : {4, 5, 6, 7, 12}) {
    const FitReport report = fit_per_cell(surface, n).report;
    EXPECT_LT(report.rms_distance, last) << n;
    last = report.rms_distance;
  }
}

TEST(FitPerCell, MovesWithTheMesh) {
  const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, 3).normalized());
  const Vector3d shift(4, -5, 6);
  const ControlMesh mesh = fan(5);
  std::vector<Vector3d> moved;
  for (const Vector3d& point : mesh.points()) moved.push_back(turn * point + shift);
  const PatchSet here = fit_per_cell(LimitSurface(mesh), 5);
  const PatchSet there = fit_per_cell(LimitSurface(mesh.with_points(moved)), 5);
  for (size_t p = 0; p < here.patches.size(); ++p) {
    for (size_t i = 0; i < here.patches[p].control_points.size(); ++i) {
      const Vector3d expected = turn * here.patches[p].control_points[i] + shift;
      EXPECT_LT((there.patches[p].control_points[i] - expected).norm(), 1e-12);
    }
  }
}

TEST(FitPerCell, TakesCellsWithoutWidth) {
  ControlMesh mesh = wavy_grid(4, 3);
  std::vector<Vector3d> points = mesh.points();
  for (int j = 0; j <= 3; ++j) points[j * 5 + 2] = points[j * 5 + 1];  // a column of no width
  points[0] = points[1];                                               // a side of no length
  const PatchSet set = fit_per_cell(LimitSurface(mesh.with_points(points)), 5);
  ASSERT_NO_THROW(set.check());
  EXPECT_TRUE(std::isfinite(set.report.largest_distance));
  EXPECT_LT(set.report.largest_distance, 1e-13 * mesh.size());
}

TEST(FitPerCell, RefusesOtherNumbersOfControlPoints) {
  const LimitSurface surface(cube());
  EXPECT_THROW(fit_per_cell(surface, 3), std::invalid_argument);
  EXPECT_THROW(fit_per_cell(surface, 17), std::invalid_argument);
}

}  // namespace
}  // namespace hull

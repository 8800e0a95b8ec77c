// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/measure_quality.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "conversion/exact/exact_conversion.h"
#include "conversion/patches/mirror.h"
#include "conversion/per_cell/per_cell.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

// The rectangle [0, 2] x [0, 1] in z = 0 of cells and patches of half a metre.
const surface::LimitSurface& plane() {
  static const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 1))};
  return surface;
}

// The patches of the plane as Bézier patches: one of two neighbours along x, and the other.
struct Pair {
  PatchSet set = fit_per_cell(plane(), 4);
  int left = -1, right = -1;
};

Pair pair_at(double y) {
  Pair pair;
  for (int p = 0; p < static_cast<int>(pair.set.patches.size()); ++p) {
    const Vector3d middle = pair.set.patches[p].position(0.5, 0.5);
    if ((middle - Vector3d(0.75, y, 0)).norm() < 1e-9) pair.left = p;
    if ((middle - Vector3d(1.25, y, 0)).norm() < 1e-9) pair.right = p;
  }
  return pair;
}

// Adds a height over the patch's x and y, which it reproduces: sum of c x^i y^j with x and y from
// 0 to 1 over the patch, given as Bernstein coefficients over x times constants along y.
void lift(BSplinePatch& patch, const std::array<double, 4>& along_x) {
  const double left = patch.position(0.5, 0.5).x() - 0.25;
  for (Vector3d& point : patch.control_points) {
    point.z() += along_x[static_cast<int>(std::lround(6.0 * (point.x() - left)))];
  }
}

TEST(MeasureQuality, FindsNothingOnExactPatches) {
  mesh::MeshArrays mesh = testing::grid(5, 3);
  for (Vector3d& p : mesh.points) p.z() = std::sin(1.3 * p.x()) * std::cos(0.9 * p.y());
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  for (const PatchSet& set : {exact_patches(surface), fit_per_cell(surface, 5)}) {
    const QualityReport report = measure_quality(surface, set);
    EXPECT_EQ(report.length, 5.0);
    EXPECT_LT(report.distance.value, 1e-13 * report.length);
    EXPECT_LE(report.rms_distance, report.distance.value);
    EXPECT_EQ(report.exact_share, 1.0);
    EXPECT_LT(report.worst_seams.gap.value, 1e-13);
    EXPECT_LT(report.worst_seams.angle.value, 1e-12);
    EXPECT_LT(report.worst_seams.curvature_jump.value, 1e-10);
    EXPECT_EQ(report.patches.size(), set.patches.size());
    EXPECT_EQ(report.theoretical_patch_count, 1);
  }
}

TEST(MeasureQuality, CountsAndSums) {
  const QualityReport report = measure_quality(plane(), fit_per_cell(plane(), 5));
  EXPECT_EQ(report.patches.size(), 8u);
  EXPECT_EQ(report.seams.size(), 10u);
  EXPECT_EQ(report.control_point_count, 8 * 25);
  EXPECT_EQ(report.knot_count, 8 * 6);  // two spans in each direction
  EXPECT_NEAR(report.area, 2.0, 1e-12);
  EXPECT_NEAR(report.patches[3].area, 0.25, 1e-13);
  EXPECT_EQ(report.patches[3].cells, 1);
}

// A Bernstein polynomial of degree 3 has its largest value 4/9 at 1/3; b1(x) b1(y) is the height.
TEST(MeasureQuality, FindsAControlPointThatWasMoved) {
  Pair pair = pair_at(0.25);
  constexpr double kMove = 1e-3;
  BSplinePatch& patch = pair.set.patches[pair.right];
  const Vector3d corner = patch.position(0.5, 0.5) - Vector3d(0.25, 0.25, 0);
  for (Vector3d& point : patch.control_points) {
    if ((point - corner - Vector3d(1, 1, 0) / 6).norm() < 1e-9) point.z() += kMove;
  }
  const QualityReport report = measure_quality(plane(), pair.set, {.samples = 12});
  const double expected = kMove * 16.0 / 81.0;
  EXPECT_NEAR(report.distance.value, expected, 0.01 * expected);
  EXPECT_LE(report.distance.value, expected * (1.0 + 1e-12));
  EXPECT_LT((report.distance.point - corner - Vector3d(1, 1, 0) / 6).norm(), 0.03);
  EXPECT_EQ(report.distance.place.cell, patch.cell);
  EXPECT_EQ(report.distance.value, report.patches[pair.right].distance.value);
  EXPECT_EQ(report.patches[pair.left].exact_area, report.patches[pair.left].area);
  // The integral of b1^2 is 3/35; over the patch's quarter of a metre squared, of 2.
  const double rms = kMove * 3.0 / 35.0;
  EXPECT_NEAR(report.patches[pair.right].rms_distance, rms, 1e-5 * rms);
  EXPECT_NEAR(report.rms_distance, rms / std::sqrt(8.0), 1e-5 * rms);
  EXPECT_NEAR(report.exact_share, 7.0 / 8.0, 1e-6);
  // b1'(0) = 3 and b1''(0) = -12, over half a metre.
  const double slope = kMove * 3.0 * 4.0 / 9.0 / 0.5;
  EXPECT_NEAR(report.worst_seams.angle.value, std::atan(slope), 0.01 * slope);
  EXPECT_LT(report.worst_seams.gap.value, 1e-14);
  const double bend = kMove * 12.0 * 4.0 / 9.0 / 0.25;
  EXPECT_NEAR(report.worst_seams.curvature_jump.value, bend, 0.01 * bend);
  EXPECT_LT((report.worst_seams.curvature_jump.point - corner - Vector3d(0, 0.5, 0) / 3).norm(),
            0.03);
}

// Two planes that meet in the line x = 1, one of them turned about it.
TEST(MeasureQuality, FindsTheAngleOfTwoPlanes) {
  constexpr double kAngle = 0.3;
  Pair pair = pair_at(0.25);
  for (BSplinePatch& patch : pair.set.patches) {
    if (patch.position(0.5, 0.5).x() < 1.0) continue;
    for (Vector3d& point : patch.control_points) {
      const double x = point.x() - 1.0;
      point = Vector3d(1.0 + x * std::cos(kAngle), point.y(), x * std::sin(kAngle));
    }
  }
  const QualityReport report = measure_quality(plane(), pair.set);
  EXPECT_NEAR(report.worst_seams.angle.value, kAngle, 1e-12);
  EXPECT_NEAR(report.worst_seams.angle.point.x(), 1.0, 1e-12);
  EXPECT_LT(report.worst_seams.gap.value, 1e-15);
  EXPECT_LT(report.worst_seams.curvature_jump.value, 1e-10);
  EXPECT_NEAR(report.distance.value, std::sin(kAngle), 1e-12);  // at x = 2
  EXPECT_NEAR(report.exact_share, 0.5, 1e-12);
}

// z = c x^2 / 2 beside a plane: tangent to it, with the curvature -c of a bowl.
TEST(MeasureQuality, FindsTheJumpOfCurvatureOfACylinderAndAPlane) {
  constexpr double kCurvature = 0.4;
  Pair pair = pair_at(0.25);
  for (BSplinePatch& patch : pair.set.patches) {
    const double x = patch.position(0.5, 0.5).x();
    const double at_end = 0.5 * kCurvature * 0.25;
    if (x > 1.0 && x < 1.5) lift(patch, {0.0, 0.0, at_end / 3.0, at_end});
    // Beyond it goes on straight: the jump there is that of the parabola's end.
    const double slope = kCurvature * 0.5 * 0.5;
    if (x > 1.5) lift(patch, {at_end, at_end + slope / 3, at_end + 2 * slope / 3, at_end + slope});
  }
  const QualityReport report = measure_quality(plane(), pair.set);
  EXPECT_LT(report.worst_seams.gap.value, 1e-15);
  EXPECT_LT(report.worst_seams.angle.value, 1e-12);
  EXPECT_NEAR(report.worst_seams.curvature_jump.value, kCurvature, 1e-12);
  EXPECT_NEAR(report.worst_seams.curvature_jump.point.x(), 1.0, 1e-12);
  // At the other end the section's slope is c / 2: c / (1 + slope^2)^1.5.
  double at_end = 0.0;
  for (const SeamQuality& seam : report.seams) {
    if (std::abs(seam.curvature_jump.point.x() - 1.5) > 1e-9) continue;
    at_end = std::max(at_end, seam.curvature_jump.value);
  }
  EXPECT_NEAR(at_end, kCurvature / std::pow(1.0 + 0.04, 1.5), 1e-12);
}

TEST(MeasureQuality, FindsGaps) {
  Pair pair = pair_at(0.25);
  BSplinePatch& patch = pair.set.patches[pair.right];
  const Vector3d corner = patch.position(0.5, 0.5) - Vector3d(0.25, 0.25, 0);
  for (Vector3d& point : patch.control_points) {
    if ((point - corner - Vector3d(0, 1, 0) / 6).norm() < 1e-9) point.z() += 1e-3;
  }
  const QualityReport report = measure_quality(plane(), pair.set, {.samples = 12});
  const Worst& gap = report.worst_seams.gap;
  EXPECT_NEAR(gap.value, 1e-3 * 4.0 / 9.0, 1e-5);
  EXPECT_LT((gap.point - corner - Vector3d(0, 0.5, 0) / 3).norm(), 0.03);
  int with_gap = 0;
  for (const SeamQuality& seam : report.seams) with_gap += seam.gap.value > 1e-14;
  EXPECT_EQ(with_gap, 1);
}

// A curve that runs along the other one at another speed leaves no gap.
TEST(MeasureQuality, MeasuresGapsToNearPoints) {
  Pair pair = pair_at(0.25);
  BSplinePatch& patch = pair.set.patches[pair.right];
  const Vector3d corner = patch.position(0.5, 0.5) - Vector3d(0.25, 0.25, 0);
  for (Vector3d& point : patch.control_points) {
    if ((point - corner - Vector3d(0, 1, 0) / 6).norm() < 1e-9) point.y() += 0.02;
  }
  const QualityReport report = measure_quality(plane(), pair.set);
  EXPECT_LT(report.worst_seams.gap.value, 1e-13);
}

TEST(MeasureQuality, ExpectsNothingOfCreases) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::creased_box(3, 2, 1))};
  const QualityReport report = measure_quality(surface, exact_patches(surface));
  EXPECT_EQ(report.patches.size(), 6u);
  EXPECT_EQ(report.seams.size(), 12u);
  for (const SeamQuality& seam : report.seams) EXPECT_FALSE(seam.is_smooth);
  EXPECT_FALSE(report.worst_seams.angle.is_measured());
  EXPECT_EQ(report.worst_seams.angle.value, 0.0);
  EXPECT_TRUE(report.worst_seams.gap.is_measured());
}

TEST(MeasureQuality, TellsAnglesAtIrregularPointsApart) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::double_pyramid(5))};
  const PatchSet set = exact_patches(surface, {.grading = 3});
  const QualityReport far = measure_quality(surface, set, {.normal_reach = 1e3});
  const QualityReport none = measure_quality(surface, set, {.normal_reach = 0.0});
  const QualityReport some = measure_quality(surface, set, {.normal_reach = 0.01});
  EXPECT_EQ(none.normal_reach, 0.0);
  const auto angle = [](const QualityReport& report) { return report.worst_seams.angle.value; };
  const auto at_points = [](const QualityReport& report) {
    return report.worst_seams.angle_at_points.value;
  };
  EXPECT_GT(angle(none), 1e-4);
  EXPECT_GT(at_points(some), 0.0);
  EXPECT_EQ(std::max(angle(some), at_points(some)), std::max(angle(none), at_points(none)));
  // All seams of this set have an irregular end.
  EXPECT_EQ(angle(far), 0.0);
  EXPECT_EQ(at_points(far), std::max(angle(none), at_points(none)));
}

TEST(MeasureQuality, ErrorsShrinkWithTheGrading) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::double_pyramid(6))};
  double distance = 1e300, rms = 1e300, share = 0.0;
  for (int grading : {2, 4, 6, 8}) {
    const QualityReport report =
        measure_quality(surface, exact_patches(surface, {.grading = grading}));
    EXPECT_LT(report.distance.value, distance) << grading;
    EXPECT_LT(report.rms_distance, 0.3 * rms) << grading;
    EXPECT_GT(report.exact_share, share) << grading;
    EXPECT_LT(report.exact_share, 1.0) << grading;
    distance = report.distance.value;
    rms = report.rms_distance;
    share = report.exact_share;
  }
}

TEST(MeasureQuality, MirrorImagesHaveGapsOnly) {
  mesh::MeshArrays mesh = testing::grid(3, 2);
  for (Vector3d& p : mesh.points) p.z() = 0.2 * p.y() * p.y() + 0.1 * p.x() * p.y();
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const PatchSet half = fit_per_cell(surface, 4);
  const QualityReport one = measure_quality(surface, half);
  const QualityReport both = measure_quality(surface, with_mirror_image(half));
  EXPECT_EQ(both.patches.size(), 2 * one.patches.size());
  EXPECT_EQ(both.area, one.area);
  EXPECT_EQ(both.patches.back().cells, 0);
  EXPECT_FALSE(both.patches.back().distance.is_measured());
  EXPECT_GT(both.seams.size(), 2 * one.seams.size());
  EXPECT_LT(both.worst_seams.gap.value, 1e-15);
  EXPECT_EQ(both.worst_seams.angle.value, one.worst_seams.angle.value);
}

// The distance from a point to the surface by brute force: the closest of a grid of every cell near
// by, refined around the best sample.
double brute_distance(const surface::LimitSurface& surface, int cell, const Vector3d& point) {
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

double brute_distance(const surface::LimitSurface& surface, const Vector3d& point) {
  double best = 1e300;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    const Vector3d middle = surface.position(cell, 0.5, 0.5);
    if ((middle - point).norm() > 0.25 * surface.mesh().size()) continue;
    best = std::min(best, brute_distance(surface, cell, point));
  }
  return best;
}

// "Never less" holds up to what lies between the report's samples: a twentieth.
TEST(MeasureQuality, BoundsAnIndependentMeasurement) {
  constexpr unsigned kSeed = 11;
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> parameter(0.0, 1.0);
  for (const mesh::MeshArrays& mesh : {testing::cube(), testing::fan(5)}) {
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const PatchSet set = fit_per_cell(surface, 5);
    const QualityReport report = measure_quality(surface, set);
    double largest = 0.0;
    for (size_t p = 0; p < set.patches.size(); p += 3) {
      for (int i = 0; i < 4; ++i) {
        // Half of them near the borders and corners, where the patches are furthest off.
        const double bend = i % 2 == 0 ? 1.0 : 4.0;
        const double u = std::pow(parameter(random), bend), v = std::pow(parameter(random), bend);
        largest = std::max(largest, brute_distance(surface, set.patches[p].position(u, v)));
      }
    }
    EXPECT_GT(largest, 0.1 * report.distance.value);
    EXPECT_LE(largest, 1.05 * report.distance.value);
    EXPECT_NEAR(brute_distance(surface, report.distance.point), report.distance.value,
                1e-3 * report.distance.value);
    EXPECT_LT(report.rms_distance, report.distance.value);
  }
}

TEST(MeasureQuality, TellsItsProgressAndCanBeEnded) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::fan(5))};
  const PatchSet set = exact_patches(surface);
  double last = 0.0;
  measure_quality(surface, set, {}, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1.0);
  const auto end = [](double share) {
    if (share > 0.4) throw std::runtime_error("enough");
  };
  EXPECT_THROW(measure_quality(surface, set, {}, end), std::runtime_error);
}

TEST(MeasureQuality, RefusesWhatDoesNotFit) {
  const PatchSet set = fit_per_cell(plane(), 4);
  EXPECT_THROW(measure_quality(plane(), set, {.samples = 0}), std::invalid_argument);
  EXPECT_THROW(measure_quality(plane(), set, {.normal_reach = -1.0}), std::invalid_argument);
  const surface::LimitSurface smaller{mesh::ControlMesh(testing::grid(1, 1))};
  EXPECT_THROW(measure_quality(smaller, set), std::invalid_argument);
  surface::LimitSurface moved = plane();
  std::vector<Vector3d> points = moved.mesh().points();
  points[0].z() += 0.1;
  moved.set_points(points);
  EXPECT_THROW(measure_quality(moved, set), std::invalid_argument);
  PatchSet unknown = set;
  unknown.blocks.clear();
  EXPECT_THROW(measure_quality(plane(), unknown), std::invalid_argument);
}

}  // namespace
}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/exact_conversion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <stdexcept>

#include "conversion/quality/measure_quality.h"
#include "test_meshes.h"
#include "trials.h"

namespace hull::conversion {
namespace {

mesh::MeshArrays random_mesh(int trial, std::mt19937& random) {
  mesh::MeshArrays mesh = trial % 3 == 0   ? testing::double_pyramid(3 + trial % 7)
                          : trial % 3 == 1 ? testing::prism(3 + trial % 7)
                                           : testing::fan(3 + trial % 6);
  testing::randomise(mesh, random, 0.15, 0.2, 0.1);
  return mesh;
}

// check() compares the curves of every edge to 1e-13 of the size, and vertices bit for bit.
TEST(ExactConversion, HasNoGapsWhateverMeets) {
  constexpr unsigned kSeed = 91;
  std::mt19937 random(kSeed);
  std::size_t most = 0;  // edges of a side
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::Scheme scheme =
        trial % 2 ? surface::Scheme::kBiermann : surface::Scheme::kCatmullClark;
    const mesh::MeshArrays mesh =
        trial % 4 == 0 ? testing::random_mesh(random, 7) : random_mesh(trial, random);
    const surface::LimitSurface surface(mesh::ControlMesh(mesh), scheme);
    const PatchSet set = exact_patches(surface, {.grading = 2 + trial % 9});
    ASSERT_NO_THROW(set.check());
    EXPECT_LE(set.largest_gap(), 1e-13 * set.size());
    EXPECT_EQ(set.blocks.size(), set.patches.size());
    for (const auto& sides : set.sides) {
      for (const PatchSide& side : sides) most = std::max(most, side.size());
    }
  }
  EXPECT_GT(most, 1u);
}

// By measurements that have nothing to do with those that the gradings were chosen by.
TEST(ExactConversion, KeepsToleranceAndSeamAngle) {
  constexpr unsigned kSeed = 93;
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < testing::trials(14); ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    mesh::MeshArrays mesh =
        trial % 2 == 0 ? testing::double_pyramid(3 + trial / 2) : testing::fan(3 + trial / 2);
    testing::randomise(mesh, random, 0.1, 0.0, 0.0);
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    for (double tolerance : {1e-5, 1e-7}) {
      const double angle = tolerance > 1e-6 ? 1e-3 : 2e-4;
      const PatchSet set = exact_patches(surface, {.tolerance = tolerance, .seam_angle = angle});
      ASSERT_NO_THROW(set.check());
      const double length = measure_quality(surface, set, {.samples = 1}).length;
      // Normals nearer to irregular points than the tolerance do not count.
      const QualityReport report =
          measure_quality(surface, set, {.normal_reach = tolerance * length});
      EXPECT_LE(report.distance.value, tolerance * report.length);
      EXPECT_LE(report.worst_seams.angle.value, angle);
    }
  }
}

// Both ends of a cell are irregular, so that nothing joins.
TEST(ExactConversion, TrianglesTakeFewControlPoints) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::sheet_of_triangles(12))};
  const PatchSet set = exact_patches(surface);
  ASSERT_NO_THROW(set.check());
  constexpr double kTriangles = 2 * 12 * 12;
  std::size_t points = 0;
  for (const BSplinePatch& patch : set.patches) points += patch.control_points.size();
  EXPECT_LE(static_cast<double>(set.patches.size()), 3.0 * kTriangles);
  EXPECT_LE(static_cast<double>(points), 470.0 * kTriangles);
  const QualityReport report = measure_quality(surface, set);
  EXPECT_LE(report.distance.value, 1e-6 * report.length);
  EXPECT_LE(report.worst_seams.angle.value, 0.02 * std::numbers::pi / 180.0);
}

TEST(ExactConversion, TellsItsProgressAndCanBeEnded) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::double_pyramid(5))};
  double last = -1.0;
  const PatchSet set = exact_patches(surface, {}, [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
  });
  EXPECT_GT(last, 0.5);
  EXPECT_THROW(exact_patches(surface, {}, [](double) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

TEST(ExactConversion, RefusesBadOptions) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  EXPECT_THROW(exact_patches(surface, {.tolerance = 0.0}), std::invalid_argument);
  EXPECT_THROW(exact_patches(surface, {.seam_angle = -1.0}), std::invalid_argument);
  EXPECT_THROW(exact_patches(surface, {.grading = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::conversion

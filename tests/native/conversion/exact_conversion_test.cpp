// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact_conversion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "conversion/grading.h"
#include "test_meshes.h"

namespace hull {
namespace {

MeshArrays random_mesh(int trial, std::mt19937& random) {
  MeshArrays mesh = trial % 3 == 0   ? testing::double_pyramid(3 + trial % 7)
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
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const MeshArrays mesh =
        trial % 4 == 0 ? testing::random_mesh(random, 7) : random_mesh(trial, random);
    const LimitSurface surface(ControlMesh(mesh), scheme);
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

TEST(ExactConversion, KeepsTheToleranceWithTheLeastGrading) {
  std::mt19937 random(93);
  MeshArrays mesh = testing::double_pyramid(5);
  testing::randomise(mesh, random, 0.1, 0.0, 0.0);
  const LimitSurface surface{ControlMesh(mesh)};
  const BlockLayout layout(surface);
  std::size_t before = 0;
  for (double tolerance : {1e-5, 1e-7, 1e-9}) {
    // A seam angle that is met at once, so that the distance alone counts.
    const PatchSet set = exact_patches(surface, {.tolerance = tolerance, .seam_angle = 1.0});
    ASSERT_NO_THROW(set.check());
    std::size_t points = 0;
    for (const BSplinePatch& patch : set.patches) points += patch.control_points.size();
    EXPECT_GT(points, before);
    before = points;
    EXPECT_EQ(set.patches.size(), layout.blocks.size());
    for (std::size_t p = 0; p < set.patches.size(); ++p) {
      for (int k = 0; k < 4; ++k) {
        for (int grading : {2, 5, 9}) {
          const CornerError error =
              corner_error(surface, layout.blocks[p], set.patches[p], k, grading);
          EXPECT_LT(error.distance, 2.0 * tolerance * surface.mesh().size());
        }
      }
    }
  }
}

TEST(ExactConversion, RefusesBadOptions) {
  const LimitSurface surface{ControlMesh(testing::grid(2, 2))};
  EXPECT_THROW(exact_patches(surface, {.tolerance = 0.0}), std::invalid_argument);
  EXPECT_THROW(exact_patches(surface, {.seam_angle = -1.0}), std::invalid_argument);
  EXPECT_THROW(exact_patches(surface, {.grading = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace hull

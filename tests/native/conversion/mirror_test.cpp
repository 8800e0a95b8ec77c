// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/mirror.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sheets.h"

namespace hull::conversion {
namespace {

// Half a keel-shaped trough over x in [0, 10]: t = 0 on the centre line.
PatchSet half_trough(double y_of_keel = 0.0) {
  return testing::sheet(3, 2, [&](double s, double t) {
    return Vector3d(10 * s, y_of_keel + 3 * t, 2 * t * t + 0.3 * std::sin(4 * s) * t);
  });
}

int free_edges(const PatchSet& set) {
  std::vector<int> uses(set.edge_count, 0);
  for (const auto& sides : set.sides) {
    for (const PatchSide& side : sides) {
      for (const SideEdge& part : side) ++uses[part.edge];
    }
  }
  return static_cast<int>(std::ranges::count(uses, 1));
}

TEST(WithMirrorImage, JoinsAlongTheCentreLineOnly) {
  const PatchSet half = half_trough(), whole = with_mirror_image(half);
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(whole.patches.size(), 12u);
  EXPECT_EQ(whole.vertex_count, 2 * 12 - 4);
  EXPECT_EQ(whole.edge_count, 2 * 17 - 3);
  EXPECT_EQ(free_edges(half), 10);
  EXPECT_EQ(free_edges(whole), 14);
}

TEST(WithMirrorImage, HasNoCellsOfItsOwn) {
  PatchSet half = half_trough();
  for (int cell = 0; cell < 6; ++cell) half.blocks.push_back({1, 1, {4 * cell}});
  const PatchSet whole = with_mirror_image(half);
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(whole.blocks[5].sides, (std::vector<int>{20}));
  EXPECT_TRUE(whole.blocks[6].sides.empty());
  half.blocks.pop_back();
  EXPECT_THROW(half.check(), std::invalid_argument);
}

TEST(WithMirrorImage, MirrorsPointsAndNormals) {
  const PatchSet half = half_trough(), whole = with_mirror_image(half);
  for (size_t p = 0; p < half.patches.size(); ++p) {
    const BSplinePatch &here = whole.patches[p], &there = whole.patches[p + 6];
    EXPECT_EQ(there.cell, here.cell);
    for (double u : {0.0, 0.3, 1.0}) {
      for (double v : {0.0, 0.6, 1.0}) {
        const surface::SurfaceJet a = here.evaluate(u, v), b = there.evaluate(v, u);
        const Eigen::DiagonalMatrix<double, 3> mirror(1, -1, 1);
        EXPECT_LT((mirror * a.point - b.point).norm(), 1e-14);
        EXPECT_LT((mirror * a.du.cross(a.dv) - b.du.cross(b.dv)).norm(), 1e-12);
      }
    }
  }
}

TEST(WithMirrorImage, PutsASeamThatIsNearlyOnThePlaneOnIt) {
  const PatchSet whole = with_mirror_image(half_trough(3e-7));  // 1e-7 of the size is 1.1e-6
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(free_edges(whole), 14);
  EXPECT_EQ(whole.patches[0].control_point(2, 0).y(), 0.0);
}

TEST(WithMirrorImage, LeavesAGapThatIsReal) {
  const PatchSet whole = with_mirror_image(half_trough(1e-3));
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(free_edges(whole), 20);
  EXPECT_EQ(whole.patches[0].control_point(2, 0).y(), 1e-3);
}

// A plate in the centre plane becomes a thin thing with two sides, joined around its edge.
TEST(WithMirrorImage, GivesAPlateInThePlaneTwoSides) {
  const PatchSet half = testing::sheet(2, 2, [](double s, double t) { return Vector3d(s, 0, t); });
  const PatchSet whole = with_mirror_image(half);
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(whole.patches.size(), 8u);
  EXPECT_EQ(free_edges(whole), 0);
  EXPECT_EQ(whole.edge_count, 12 + 4);
  EXPECT_EQ(whole.vertex_count, 9 + 1);
}

}  // namespace
}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/mirror.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "conversion/exact/exact_conversion.h"
#include "mesh/centre_plane.h"
#include "sheets.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

// Half a keel-shaped trough over x in [0, 10]: t = 0 on the centre line.
PatchSet half_trough(double y_of_keel = 0.0) {
  return testing::sheet(3, 2, [&](double s, double t) {
    return Vector3d(10 * s, y_of_keel + 3 * t, 2 * t * t + 0.3 * std::sin(4 * s) * t);
  });
}

TEST(WithMirrorImage, JoinsAlongTheCentreLineOnly) {
  const PatchSet half = half_trough(), whole = with_mirror_image(half);
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(whole.patches.size(), 12u);
  EXPECT_EQ(whole.vertex_count, 2 * 12 - 4);
  EXPECT_EQ(whole.edge_count, 2 * 17 - 3);
  EXPECT_EQ(testing::free_edges(half), 10);
  EXPECT_EQ(testing::free_edges(whole), 14);
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
  const PatchSet whole = with_mirror_image(half_trough(5e-9));  // 1e-9 of the size is 1.1e-8
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(testing::free_edges(whole), 14);
  EXPECT_EQ(whole.patches[0].control_point(2, 0).y(), 0.0);
}

// A side that runs along the plane and then, beside another patch, off it by less than the
// tolerance.
TEST(WithMirrorImage, LeavesWhatAnotherPatchHasBesideTheSeam) {
  const double off = 1e-9;  // 3e-10 of the size
  BSplinePatch wide{1, 1, {0, 0, 0.5, 1, 1}, {0, 0, 1, 1}, 3, 2, {}, 0};
  wide.control_points = {{0, 0, 0}, {0, 1, 1}, {1, 0, 0}, {1, 1, 1}, {2, off, 0}, {2, 1, 1}};
  BSplinePatch below{1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, 2, 2, {}, 1};
  below.control_points = {{1, 1, -1}, {1, 0, 0}, {2, 1, -1}, {2, off, 0}};
  PatchSet half;
  half.patches = {wide, below};
  half.corners = {{0, 2, 3, 4}, {5, 6, 2, 1}};
  half.sides = {
      {PatchSide{{0, 0, 1, 0.0, 0.5}, {1, 1, 2, 0.5, 1.0}}, whole_side(2, 2, 3),
       whole_side(3, 3, 4), whole_side(4, 4, 0)},
      {whole_side(5, 5, 6), whole_side(6, 6, 2), whole_side(1, 2, 1), whole_side(7, 1, 5)}};
  half.vertex_count = 7;
  half.edge_count = 8;
  ASSERT_NO_THROW(half.check());
  const PatchSet whole = with_mirror_image(half);
  EXPECT_NO_THROW(whole.check());
  EXPECT_EQ(whole.patches[0].control_point(2, 0).y(), off);
  EXPECT_EQ(whole.edge_count, 2 * 8 - 1);
}

// A border that leaves the plane in a short edge is within kOnCentrePlane of it at first, but was
// not put there: moving it now would part it from its neighbours.
TEST(WithMirrorImage, LeavesABorderThatRisesFromThePlane) {
  mesh::MeshArrays arrays = testing::grid(8, 3);
  arrays.points[8] = {7.001, 1.2e-5, 0.0};
  const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  ASSERT_TRUE(mesh::vertices_near_centre_line(surface.mesh()).empty());
  const PatchSet whole = with_mirror_image(exact_patches(surface));
  EXPECT_NO_THROW(whole.check());
}

TEST(WithMirrorImage, LeavesAGapThatIsReal) {
  const PatchSet whole = with_mirror_image(half_trough(1e-3));
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(testing::free_edges(whole), 20);
  EXPECT_EQ(whole.patches[0].control_point(2, 0).y(), 1e-3);
}

// A plate in the centre plane becomes a thin thing with two sides, joined around its edge.
TEST(WithMirrorImage, GivesAPlateInThePlaneTwoSides) {
  const PatchSet half = testing::sheet(2, 2, [](double s, double t) { return Vector3d(s, 0, t); });
  const PatchSet whole = with_mirror_image(half);
  ASSERT_NO_THROW(whole.check());
  EXPECT_EQ(whole.patches.size(), 8u);
  EXPECT_EQ(testing::free_edges(whole), 0);
  EXPECT_EQ(whole.edge_count, 12 + 4);
  EXPECT_EQ(whole.vertex_count, 9 + 1);
}

}  // namespace
}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/centre_plane.h"

#include <gtest/gtest.h>

#include "mesh/tolerances.h"
#include "test_meshes.h"

namespace hull::mesh {
namespace {

// A sheet over [0, 8] x [0, 3] whose border y = 0 is the points 0 … 8.
MeshArrays sheet() { return testing::grid(8, 3); }

double size_of(const MeshArrays& arrays) { return ControlMesh(arrays).size(); }

TEST(CentrePlane, BordersThatAreNearlyInItArePutThere) {
  MeshArrays arrays = sheet();
  const double noise = 0.9 * kOnCentrePlane * size_of(arrays);
  arrays.points[3].y() = noise;
  arrays.points[4].y() = -noise;
  arrays.points[8].y() = noise;
  const ControlMesh mesh(arrays);
  const auto points = points_with_centre_line(mesh);
  for (int i = 0; i <= 8; ++i) EXPECT_EQ(points[i].y(), 0.0) << i;
  for (std::size_t i = 9; i < points.size(); ++i) EXPECT_EQ(points[i], arrays.points[i]);
  EXPECT_EQ(points[3].x(), arrays.points[3].x());
  EXPECT_TRUE(vertices_near_centre_line(mesh).empty());
}

TEST(CentrePlane, BordersThatAreNearItAreTold) {
  for (const double distance : {1.1 * kOnCentrePlane, 1e-5, 0.9 * kNearCentrePlane}) {
    MeshArrays arrays = sheet();
    arrays.points[3].y() = distance * size_of(arrays);
    arrays.points[4].y() = -arrays.points[3].y();
    const ControlMesh mesh(arrays);
    EXPECT_EQ(vertices_near_centre_line(mesh), (std::vector<int>{3, 4}));
    EXPECT_EQ(points_with_centre_line(mesh)[3], arrays.points[3]);
  }
}

// The short edges at 4 run along the plane only when 3 and 5 are on it.
TEST(CentrePlane, NoneIsLeftWhenAllThatAreToldHaveBeenPutThere) {
  MeshArrays arrays = sheet();
  arrays.points[3].x() = 3.98;
  arrays.points[5].x() = 4.02;
  arrays.points[3].y() = arrays.points[5].y() = 0.8 * kNearCentrePlane * size_of(arrays);
  arrays.points[4].y() = 1e-4;
  const std::vector<int> near = vertices_near_centre_line(ControlMesh(arrays));
  EXPECT_EQ(near, (std::vector<int>{3, 4, 5}));
  for (int v : near) arrays.points[v].y() = 0.0;
  EXPECT_TRUE(vertices_near_centre_line(ControlMesh(arrays)).empty());
}

// Where most of the line is on the plane; ends of it that leave the plane are none.
TEST(CentrePlane, GapsOfTheCentreLineAreTold) {
  for (const double distance : {1.1 * kNearCentrePlane, 0.9 * kAtCentreLine}) {
    MeshArrays arrays = sheet();
    const double off = distance * size_of(arrays);
    EXPECT_TRUE(gaps_in_centre_line(ControlMesh(arrays)).empty());
    arrays.points[3].y() = arrays.points[4].y() = off;
    arrays.points[6].y() = -off;
    EXPECT_EQ(gaps_in_centre_line(ControlMesh(arrays)), (std::vector<int>{3, 4, 6}));
    arrays.points[0].y() = arrays.points[8].y() = off;
    EXPECT_EQ(gaps_in_centre_line(ControlMesh(arrays)), (std::vector<int>{3, 4, 6}));
    for (int v : {2, 5}) arrays.points[v].y() = off;  // more than half: as of a bar keel
    EXPECT_TRUE(gaps_in_centre_line(ControlMesh(arrays)).empty());
  }
  MeshArrays arrays = sheet();
  arrays.points[4].y() = 1.1 * kAtCentreLine * size_of(arrays);
  EXPECT_TRUE(gaps_in_centre_line(ControlMesh(arrays)).empty());
}

// A sheet that is all near the plane: wherever its border begins, the gap is one.
TEST(CentrePlane, GapsOfABorderThatIsInThePlaneAllAround) {
  MeshArrays arrays = sheet();
  for (auto& point : arrays.points) point = {point.x(), 0.0, point.y()};
  for (int v : {0, 4, 8}) {
    MeshArrays open = arrays;
    open.points[v].y() = 0.5 * kAtCentreLine * size_of(arrays);
    EXPECT_EQ(gaps_in_centre_line(ControlMesh(open)), (std::vector<int>{v}));
  }
}

TEST(CentrePlane, WhatIsFurtherOffIsMeant) {
  MeshArrays arrays = sheet();
  arrays.points[3].y() = 1.1 * kNearCentrePlane * size_of(arrays);
  EXPECT_TRUE(vertices_near_centre_line(ControlMesh(arrays)).empty());
}

// Inner points near the plane, as of a thin skeg, and borders that cross it or leave it in a short
// edge, stay as they are.
TEST(CentrePlane, OnlyBordersAlongItCount) {
  MeshArrays arrays = sheet();
  const double near = 0.5 * kOnCentrePlane * size_of(arrays);
  arrays.points[9 + 4].y() = near;  // inner
  arrays.points[2 * 9].y() = near;  // on the border x = 0, alone
  arrays.points[9].x() = 0.0;
  arrays.points[9].y() = 20.0 * near;  // a short edge that leaves the plane
  const ControlMesh mesh(arrays);
  EXPECT_EQ(points_with_centre_line(mesh), arrays.points);
  EXPECT_TRUE(vertices_near_centre_line(mesh).empty());
}

}  // namespace
}  // namespace hull::mesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/control_mesh.h"
#include "mesh/refined_view.h"
#include "test_meshes.h"

namespace hull::mesh {
namespace {

using testing::cube;
using testing::grid;

// What must hold of any half-edge structure.
void expect_consistent(const Topology& t) {
  for (int h = 0; h < t.half_edge_count(); ++h) {
    EXPECT_EQ(t.prev(t.next(h)), h);
    EXPECT_EQ(t.face(t.next(h)), t.face(h));
    const int g = t.twin(h);
    if (g < 0) {
      EXPECT_TRUE(t.is_crease(h));
      continue;
    }
    EXPECT_EQ(t.twin(g), h);
    EXPECT_EQ(t.origin(g), t.origin(t.next(h)));
    EXPECT_EQ(t.edge(g), t.edge(h));
    EXPECT_EQ(t.is_crease(g), t.is_crease(h));
    EXPECT_NE(t.is_edge_front(g), t.is_edge_front(h));
  }
}

TEST(Topology, CountsOfACube) {
  const ControlMesh mesh(cube());
  const Topology& t = mesh.topology();
  EXPECT_EQ(t.vertex_count(), 8);
  EXPECT_EQ(t.edge_count(), 12);
  EXPECT_EQ(t.face_count(), 6);
  const Topology fine = t.refined();
  EXPECT_EQ(fine.vertex_count(), 26);
  EXPECT_EQ(fine.edge_count(), 48);
  EXPECT_EQ(fine.face_count(), 24);
}

TEST(Topology, KindsFollowFromCreases) {
  MeshArrays arrays = grid(4, 4);
  // A crease from the middle to the border, a corner where three meet.
  arrays.creases = {{12, 13}, {13, 14}, {13, 8}};
  const ControlMesh mesh(arrays);
  const Topology& t = mesh.topology();
  EXPECT_EQ(t.kind(12), VertexKind::kDart);
  EXPECT_EQ(t.kind(13), VertexKind::kCorner);
  EXPECT_EQ(t.kind(14), VertexKind::kCorner);  // two borders and a crease
  EXPECT_EQ(t.kind(8), VertexKind::kDart);
  EXPECT_EQ(t.kind(0), VertexKind::kCorner);  // one face at a border
  EXPECT_EQ(t.kind(1), VertexKind::kCrease);
  EXPECT_EQ(t.kind(6), VertexKind::kSmooth);
}

TEST(Topology, BorderCornersAreRoundedOnRequest) {
  MeshArrays arrays = grid(2, 2);
  arrays.round_border_corners = true;
  EXPECT_EQ(ControlMesh(arrays).topology().kind(0), VertexKind::kCrease);
}

TEST(Topology, SectorsAreCountedBetweenCreases) {
  MeshArrays arrays = testing::fan(7);
  arrays.creases = {{0, 1}, {0, 5}};  // rays 0 and 2: sectors of 2 and 5 faces
  const ControlMesh mesh(arrays);
  const Topology& t = mesh.topology();
  std::vector<int> sizes;
  for (int f = 0; f < 7; ++f) sizes.push_back(t.sector_faces(t.first_half_edge(f)));
  EXPECT_EQ(sizes, (std::vector<int>{2, 2, 5, 5, 5, 5, 5}));
}

TEST(Topology, RefinementOfRandomMeshesIsConsistent) {
  constexpr unsigned kSeed = 20250101;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < 60; ++trial) {
    const ControlMesh mesh(testing::random_mesh(random, 12));
    const Topology fine = mesh.topology().refined();
    expect_consistent(mesh.topology());
    expect_consistent(fine);
    // Sectors counted anew on the arrays of the finer mesh agree with those derived.
    std::vector<int> sizes(fine.face_count(), 4), vertices;
    std::vector<std::array<int, 2>> creases;
    std::vector<int> corners;
    for (int h = 0; h < fine.half_edge_count(); ++h) {
      vertices.push_back(fine.origin(h));
      if (fine.is_crease(h)) creases.push_back({fine.origin(h), fine.origin(fine.next(h))});
    }
    for (int v = 0; v < fine.vertex_count(); ++v) {
      if (fine.kind(v) == VertexKind::kCorner || fine.kind(v) == VertexKind::kCone) {
        corners.push_back(v);
      }
    }
    const Topology anew(fine.vertex_count(), sizes, vertices, creases, corners,
                        /*round_border_corners=*/true);
    ASSERT_EQ(anew.edge_count(), fine.edge_count());
    for (int h = 0; h < fine.half_edge_count(); ++h) {
      EXPECT_EQ(anew.twin(h), fine.twin(h));
      EXPECT_EQ(anew.sector_faces(h), fine.sector_faces(h));
      EXPECT_EQ(anew.kind_at(h), fine.kind_at(h));
    }
  }
}

}  // namespace
}  // namespace hull::mesh

// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/control_mesh.h"
#include "test_meshes.h"

namespace hull::mesh {
namespace {

using testing::add_face;
using testing::cube;
using testing::grid;

// The first problem of a broken mesh; its message must name `named`, and construction must throw
// it.
MeshProblem first_error(const MeshArrays& mesh, const std::string& named) {
  const std::vector<MeshProblem> problems = check_mesh(mesh);
  EXPECT_FALSE(problems.empty());
  if (problems.empty()) return {};
  EXPECT_EQ(problems.front().severity, Severity::kError);
  EXPECT_NE(problems.front().message.find(named), std::string::npos) << problems.front().message;
  try {
    const ControlMesh built(mesh);
    ADD_FAILURE() << "constructed all the same";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), problems.front().message);
  }
  return problems.front();
}

TEST(MeshCheck, SoundMeshesHaveNoProblems) {
  EXPECT_TRUE(check_mesh(cube()).empty());
  EXPECT_TRUE(check_mesh(grid(3, 2)).empty());
  EXPECT_TRUE(check_mesh(testing::prism(7)).empty());
}

TEST(ControlMesh, PointsWithoutFacesHaveNoSize) {
  MeshArrays arrays = cube();
  arrays.points.emplace_back(1000.0, 0.0, 0.0);
  const ControlMesh mesh(arrays), plain(cube());
  EXPECT_EQ(mesh.size(), plain.size());
  EXPECT_EQ(mesh.box().max(), plain.box().max());
  arrays.points.back().y() = -3000.0;
  for (int i = 0; i < 8; ++i) arrays.points[i] *= 2.0;
  EXPECT_EQ(mesh.with_points(arrays.points).size(), 2.0 * plain.size());
}

TEST(ControlMesh, WarnsOfItsPointsAsTheyAre) {
  MeshArrays arrays = grid(2, 1);
  arrays.points.emplace_back(9.0, 9.0, 9.0);
  arrays.creases = {{0, 5}};
  const ControlMesh sound(arrays);
  for (const int p : {1, 3, 4}) arrays.points[p] = arrays.points[0];
  const ControlMesh flat(arrays), moved = sound.with_points(arrays.points);
  const auto messages = [](const std::vector<MeshProblem>& problems) {
    std::vector<std::string> result;
    for (const MeshProblem& problem : problems) result.push_back(problem.message);
    return result;
  };
  EXPECT_EQ(sound.warnings().size(), 2u);
  EXPECT_EQ(flat.warnings().size(), 3u);
  EXPECT_EQ(messages(flat.warnings()), messages(check_mesh(arrays)));
  EXPECT_EQ(messages(moved.warnings()), messages(flat.warnings()));
  EXPECT_EQ(messages(flat.with_points(sound.points()).warnings()), messages(sound.warnings()));
}

TEST(MeshCheck, EdgeOfThreeFaces) {
  MeshArrays mesh = cube();
  mesh.points.emplace_back(0.0, 0.0, 5.0);
  add_face(mesh, {0, 1, 8});
  const MeshProblem problem = first_error(mesh, "0–1");
  EXPECT_EQ(problem.kind, ElementKind::kEdge);
  EXPECT_EQ(problem.elements, (std::vector<int>{0, 1}));
}

TEST(MeshCheck, FaceTurnedTheOtherWay) {
  MeshArrays mesh = cube();
  std::reverse(mesh.face_vertices.begin(), mesh.face_vertices.begin() + 4);
  const MeshProblem problem = first_error(mesh, "4 edges");
  EXPECT_EQ(problem.elements.size(), 8u);
}

TEST(MeshCheck, PointJoiningTwoFans) {
  MeshArrays mesh = grid(1, 1);
  mesh.points.emplace_back(5.0, 0.0, 0.0);
  mesh.points.emplace_back(5.0, 5.0, 0.0);
  add_face(mesh, {0, 4, 5});
  EXPECT_EQ(first_error(mesh, "Point 0 joins").elements, std::vector<int>{0});
}

TEST(MeshCheck, TwoClosedFansAtOnePoint) {
  MeshArrays mesh = testing::double_pyramid(4);
  MeshArrays other = mesh;
  // A second body hangs on point 5 of the first.
  for (int& v : other.face_vertices) v = v == 4 ? 5 : v + 6;
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (auto& p : other.points) p.z() += 2.0;
  mesh.face_sizes.insert(mesh.face_sizes.end(), other.face_sizes.begin(), other.face_sizes.end());
  mesh.face_vertices.insert(mesh.face_vertices.end(), other.face_vertices.begin(),
                            other.face_vertices.end());
  EXPECT_EQ(first_error(mesh, "Point 5 joins").elements, std::vector<int>{5});
}

TEST(MeshCheck, BadArrays) {
  MeshArrays mesh = cube();
  mesh.face_vertices[7] = 8;
  first_error(mesh, "names point 8");
  mesh = cube();
  mesh.face_vertices[3] = -1;
  first_error(mesh, "names point -1");
  mesh = cube();
  mesh.face_vertices.pop_back();
  first_error(mesh, "add up to 24");
  mesh = cube();
  mesh.face_sizes[2] = 2;
  first_error(mesh, "Face 2 has fewer");
  mesh = cube();
  mesh.creases.push_back({0, 99});
  first_error(mesh, "names point 99");
  mesh = cube();
  mesh.corners.push_back(-7);
  first_error(mesh, "names point -7");
  first_error(MeshArrays{}, "no faces");
}

TEST(MeshCheck, SizesThatOverflowWhenAdded) {
  MeshArrays mesh = cube();
  mesh.face_sizes = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 26};
  first_error(mesh, "more than 128 corners");
}

TEST(MeshCheck, NegativeSizesAndSumsThatDoNotMatch) {
  MeshArrays mesh = cube();
  mesh.face_sizes[4] = -4;
  first_error(mesh, "Face 4 has fewer than three");
  mesh = cube();
  mesh.face_sizes[4] = std::numeric_limits<int>::min();
  first_error(mesh, "Face 4 has fewer than three");
  mesh = cube();
  mesh.face_sizes.push_back(4);
  first_error(mesh, "add up to 28, but there are 24");
}

// Refused before anything is computed of them.
TEST(MeshCheck, MoreCornersThanCanBeCounted) {
  MeshArrays mesh = cube();
  mesh.face_vertices.assign(kMaxHalfEdges + std::size_t{1}, 0);
  first_error(mesh, "16777217 face corners");
  mesh = cube();
  mesh.face_sizes.assign(kMaxHalfEdges + std::size_t{1}, 4);
  first_error(mesh, "16777217 faces");
}

TEST(MeshCheck, HundredThousandFacesAroundAPoint) {
  constexpr int kFaces = 100'000;
  MeshArrays mesh;
  for (int i = 0; i < kFaces; ++i) {
    const double angle = 2.0 * M_PI * i / kFaces;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    add_face(mesh, {i, (i + 1) % kFaces, kFaces});
  }
  mesh.points.emplace_back(0.0, 0.0, 0.0);
  EXPECT_EQ(first_error(mesh, "Point 100000 has more than 128 faces").elements,
            std::vector<int>{kFaces});
}

// The greatest valence that is not refused.
TEST(MeshCheck, PointsAndFacesOfGreatestValence) {
  EXPECT_TRUE(check_mesh(testing::double_pyramid(kMaxValence)).empty());
  EXPECT_TRUE(check_mesh(testing::prism(kMaxValence)).empty());
  first_error(testing::double_pyramid(kMaxValence + 1), "more than 128 faces");
  first_error(testing::prism(kMaxValence + 1), "more than 128 corners");
}

// One-sided: wherever the seam is put, the faces at it are turned against each other.
TEST(MeshCheck, MoebiusStrip) {
  constexpr int kFaces = 7;
  MeshArrays mesh;
  for (int i = 0; i < kFaces; ++i) {
    const double angle = 2.0 * M_PI * i / kFaces, twist = 0.5 * angle;
    for (double side : {-0.4, 0.4}) {
      const double r = 2.0 + side * std::cos(twist);
      mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), side * std::sin(twist));
    }
    if (i > 0) add_face(mesh, {2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  EXPECT_TRUE(check_mesh(mesh).empty());
  add_face(mesh, {2 * kFaces - 2, 1, 0, 2 * kFaces - 1});
  EXPECT_EQ(first_error(mesh, "in the same direction").kind, ElementKind::kEdge);
}

TEST(MeshCheck, FaceTwice) {
  MeshArrays mesh = grid(2, 2);
  add_face(mesh, {0, 1, 4, 3});
  first_error(mesh, "more than two faces");
  mesh = grid(1, 1);
  add_face(mesh, {0, 1, 3, 2});
  first_error(mesh, "4 edges (0–1, 0–2, 1–3, 2–3) are run through in the same direction");
  // Turned the other way it closes the first one up, to a pillow.
  mesh = grid(1, 1);
  add_face(mesh, {0, 2, 3, 1});
  const std::vector<MeshProblem> problems = check_mesh(mesh);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("lie between only two faces"), std::string::npos);
}

TEST(MeshCheck, BadPoints) {
  MeshArrays mesh = cube();
  mesh.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_error(mesh, "Point 3").elements, std::vector<int>{3});
  mesh = cube();
  mesh.points[3].y() = std::numeric_limits<double>::infinity();
  first_error(mesh, "Point 3");
  mesh = cube();
  for (double far : {1e10, -1e300, 1.7e308}) {
    mesh.points[6].x() = far;
    first_error(mesh, "Point 6 lies more than 1e9 m from the origin");
  }
  mesh.points[6].x() = 1e-310;  // a denormal number is a number
  EXPECT_TRUE(check_mesh(mesh).empty());
}

TEST(MeshCheck, RepeatedCornerAndHugeFace) {
  MeshArrays mesh = cube();
  mesh.face_vertices[2] = mesh.face_vertices[0];
  first_error(mesh, "Face 0 has the same point twice");
  mesh = MeshArrays{};
  std::vector<int> corners;
  for (int i = 0; i < 1'000'000; ++i) {
    mesh.points.emplace_back(std::cos(i), std::sin(i), 0.0);
    corners.push_back(i);
  }
  add_face(mesh, corners);
  first_error(mesh, "Face 0 has more than 128 corners");
}

TEST(MeshCheck, Warnings) {
  MeshArrays mesh = grid(2, 2);
  mesh.points.emplace_back(9.0, 9.0, 9.0);
  mesh.corners.push_back(4);
  mesh.creases.push_back({0, 8});
  const std::vector<MeshProblem> problems = check_mesh(mesh);
  ASSERT_EQ(problems.size(), 3u);
  for (const MeshProblem& p : problems) EXPECT_EQ(p.severity, Severity::kWarning);
  EXPECT_EQ(problems[0].elements, std::vector<int>{9});
  EXPECT_EQ(problems[1].elements, std::vector<int>{4});
  EXPECT_EQ(problems[2].elements, (std::vector<int>{0, 8}));
  EXPECT_EQ(ControlMesh(mesh).warnings().size(), 3u);
}

TEST(MeshCheck, FaceWithoutArea) {
  MeshArrays mesh = grid(2, 1);
  for (int v : {0, 1, 3, 4}) mesh.points[v].y() = 0.0;
  const std::vector<MeshProblem> problems = check_mesh(mesh);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, ElementKind::kFace);
  EXPECT_EQ(problems[0].elements, std::vector<int>{0});
}

}  // namespace
}  // namespace hull::mesh

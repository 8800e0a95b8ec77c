// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "mesh/control_mesh.h"
#include "test_meshes.h"

namespace hull {
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
  first_error(mesh, "more than 512 corners");
}

TEST(MeshCheck, BadPoints) {
  MeshArrays mesh = cube();
  mesh.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_error(mesh, "Point 3").elements, std::vector<int>{3});
  mesh = cube();
  mesh.points[3].y() = std::numeric_limits<double>::infinity();
  first_error(mesh, "Point 3");
  mesh = cube();
  mesh.points[6].x() = 1e10;
  first_error(mesh, "Point 6");
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
  first_error(mesh, "Face 0 has more than 512 corners");
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
}  // namespace hull

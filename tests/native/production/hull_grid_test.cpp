// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/hull_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "production/grid/folded_loop.h"
#include "production/models/closed_model.h"
#include "production/models/slices.h"
#include "test_meshes.h"

namespace hull::production {
namespace {

TEST(SidePointsTest, LinesCrossWhereTheSidesSay) {
  const mesh::ControlMesh mesh(testing::grid(1, 1));
  const surface::LimitSurface surface(mesh);
  surface::CellDivisions divisions(surface.cells(), 2);
  SidePoints sides(surface.cells(), divisions);
  EXPECT_EQ(sides.uv(0, 1, 1), Eigen::Vector2d(0.5, 0.5));
  // The lower side divided at 0.2, the left one at 0.7: lines from (0.2, 0) to (0.5, 1) and from
  // (0, 0.7) to (1, 0.5) cross where u = 0.2 + 0.3 v, v = 0.7 - 0.2 u.
  const auto divide = [&](int h, double t) {
    const double front = surface.cells().is_edge_front(h) ? t : 1.0 - t;
    sides.set(surface.cells().edge(h), {0.0, front, 1.0});
  };
  divide(0, 0.2);
  divide(3, 0.3);
  const double u = (0.2 + 0.3 * 0.7) / 1.06;
  EXPECT_NEAR(sides.uv(0, 1, 1).x(), u, 1e-15);
  EXPECT_NEAR(sides.uv(0, 1, 1).y(), 0.7 - 0.2 * u, 1e-15);
  EXPECT_EQ(sides.uv(0, 2, 0), Eigen::Vector2d(1.0, 0.0));
}

// A ring of points of uneven numbers on both sides, counter-clockwise from above.
TEST(FoldedLoopTest, LinesJoinWhatIsEquallyFar) {
  std::vector<Vector3d> points;
  std::vector<int> loop;
  const auto add = [&](double x, double y) {
    loop.push_back(static_cast<int>(points.size()));
    points.push_back({x, y, 0.1 * x});
  };
  for (double x : {4.0, 3.0, 1.0}) add(x, x == 4.0 ? 0.0 : 1.0);
  add(0.0, 0.0);
  for (double x : {1.0, 2.0, 3.0}) add(x, -1.0);
  const auto lines = lines_across(points, loop, 0.0);
  // Port chain 4, 3, 1, 0; to starboard 4, 3, 2, 1, 0: abreast at 3 and at 1.
  const std::vector<std::array<int, 2>> wanted{{0, 0}, {1, 6}, {1, 5}, {2, 4}, {3, 3}};
  EXPECT_EQ(lines, wanted);
  EXPECT_THROW(lines_across(points, loop, -5.0), std::invalid_argument);
}

// An open half cylinder along x, y >= 0: closed by the centre plane's lines to a whole one.
TEST(ClosedModelTest, ClosesHalvesAndWholesAlike) {
  for (const bool mirrored : {true, false}) {
    mesh::MeshArrays arrays = testing::creased_box(6.0, 2.0, 1.0);
    // Without its top, or, of the half, with its port side alone.
    mesh::MeshArrays open;
    open.points = arrays.points;
    int first = 0;
    for (int size : arrays.face_sizes) {
      std::vector<int> corners(arrays.face_vertices.begin() + first,
                               arrays.face_vertices.begin() + first + size);
      first += size;
      double top = 0.0;
      for (int c : corners) top += arrays.points[c].z();
      if (top < 3.5) testing::add_face(open, corners);
    }
    open.creases = arrays.creases;
    if (mirrored) {
      for (auto& p : open.points) p.y() = std::max(p.y(), 0.0);
      // The faces in the centre plane go.
      mesh::MeshArrays half;
      half.points = open.points;
      half.creases = open.creases;
      first = 0;
      for (int size : open.face_sizes) {
        std::vector<int> corners(open.face_vertices.begin() + first,
                                 open.face_vertices.begin() + first + size);
        first += size;
        double breadth = 0.0;
        for (int c : corners) breadth += open.points[c].y();
        if (breadth > 0.0) testing::add_face(half, corners);
      }
      open = half;
    }
    const surface::LimitSurface surface{mesh::ControlMesh(open)};
    const analysis::HullBody body(surface, mirrored);
    const ClosedModel model = closed_model(body, 0.01);
    EXPECT_EQ(open_sides(model), 0) << mirrored;
    EXPECT_NEAR(model.volume(), 12.0, 1e-12) << mirrored;
    EXPECT_NEAR(model.area(), 2.0 * (12.0 + 6.0 + 2.0), 1e-12) << mirrored;
    const ModelLayers parts = layers(model, 0.3);
    ASSERT_EQ(parts.slices.size(), 4u);
    EXPECT_NEAR(parts.volume(), 12.0, 1e-12);
    EXPECT_NEAR(parts.slices[3].height, 0.95, 1e-12);
  }
}

TEST(ClosedModelTest, RoundSurfacesAreWithinTheTolerance) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const analysis::HullBody body(surface, false);
  const double exact = body.immersion({Vector3d::UnitZ(), 5.0}).volume;
  for (const double tolerance : {0.02, 0.005, 0.00125}) {
    const ClosedModel model = closed_model(body, tolerance);
    EXPECT_EQ(open_sides(model), 0);
    EXPECT_LT(std::abs(model.volume() - exact), tolerance * model.area());
    EXPECT_LT(model.volume(), exact);
  }
  EXPECT_THROW(closed_model(body, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace hull::production

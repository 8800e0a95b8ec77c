// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/tessellation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "test_meshes.h"
#include "trials.h"

namespace hull::surface {
namespace {

constexpr unsigned kTessellationSeed = 5150;

double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                            const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = square > 0.0;
  const Vector3d* corners[] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const Vector3d &from = *corners[i], &to = *corners[(i + 1) % 3];
    const Vector3d along = to - from;
    const double length = along.squaredNorm();
    const double s = length > 0.0 ? std::clamp((p - from).dot(along) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (p - from - s * along).norm());
    inside = inside && along.cross(p - from).dot(normal) >= 0.0;
  }
  return inside ? std::abs((p - a).dot(normal)) / std::sqrt(square) : nearest;
}

// Farther of the distances for the two ways of cutting.
double distance_to_quad(const Vector3d& p, const std::array<Vector3d, 4>& q) {
  const double one = std::min(distance_to_triangle(p, q[0], q[1], q[2]),
                              distance_to_triangle(p, q[0], q[2], q[3]));
  const double other = std::min(distance_to_triangle(p, q[0], q[1], q[3]),
                                distance_to_triangle(p, q[1], q[2], q[3]));
  return std::max(one, other);
}

struct Measured {
  double largest = 0.0;  // distance of the surface from its own quadrilaterals, sampled
  int most = 1;          // divisions of a cell
};

// Quadrilaterals come cell by cell, those along u first; where they begin and end tells nu and nv.
Measured measure(const LimitSurface& surface, const Tessellation& t, int samples) {
  Measured result;
  const int per_row = samples + 1;
  std::size_t quad = 0;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    // The first quadrilateral's corners are in this cell, maybe known from another.
    const std::size_t begin = quad;
    std::size_t nu = 1;
    const auto& quads = t.quads;
    while (begin + nu < quads.size() && quads[begin + nu][0] == quads[begin + nu - 1][1] &&
           quads[begin + nu][3] == quads[begin + nu - 1][2]) {
      const Vector3d corner = surface.position(cell, 1.0, 0.0);
      if ((t.points[quads[begin + nu - 1][1]] - corner).norm() < 1e-12 * surface.mesh().size()) {
        break;
      }
      ++nu;
    }
    std::size_t nv = 1;
    const Vector3d corner = surface.position(cell, 0.0, 1.0);
    while ((t.points[quads[begin + (nv - 1) * nu][3]] - corner).norm() >
           1e-12 * surface.mesh().size()) {
      ++nv;
    }
    result.most = std::max({result.most, static_cast<int>(nu), static_cast<int>(nv)});
    quad = begin + nu * nv;
    for (std::size_t k = 0; k < nu * nv; ++k) {
      std::array<Vector3d, 4> q;
      for (int c = 0; c < 4; ++c) q[c] = t.points[quads[begin + k][c]];
      for (int s = 0; s < per_row * per_row; ++s) {
        const double u = (k % nu + static_cast<double>(s % per_row) / samples) / nu;
        const double v = (k / nu + static_cast<double>(s / per_row) / samples) / nv;
        const Vector3d p = surface.position(cell, std::min(u, 1.0), std::min(v, 1.0));
        result.largest = std::max(result.largest, distance_to_quad(p, q));
      }
    }
  }
  EXPECT_EQ(quad, t.quads.size());
  return result;
}

void expect_watertight(const Tessellation& t, bool closed) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& quad : t.quads) {
    for (int k = 0; k < 4; ++k) ++sides[{quad[k], quad[(k + 1) % 4]}];
  }
  for (const auto& [side, count] : sides) {
    ASSERT_EQ(count, 1);
    if (closed) {
      ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
  }
}

// How many quadrilateral sides are on a border.
int border_sides(const Tessellation& t) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& quad : t.quads) {
    for (int k = 0; k < 4; ++k) ++sides[std::minmax(quad[k], quad[(k + 1) % 4])];
  }
  int count = 0;
  for (const auto& side : sides) {
    EXPECT_LE(side.second, 2);
    count += side.second == 1;
  }
  return count;
}

void expect_points_of_surface(const LimitSurface& surface, const Tessellation& t) {
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    ASSERT_GE(t.cells[i], 0);
    ASSERT_LT((surface.position(t.cells[i], t.uv[i].x(), t.uv[i].y()) - t.points[i]).norm(),
              1e-14 * surface.mesh().size());
  }
}

// Closed bodies have closed tessellations, each edge of two quadrilaterals run both ways, and their
// normals are those of the surface.
TEST(Tessellation, IsWatertight) {
  for (int n : {1, 2, 5}) {
    const LimitSurface surface{mesh::ControlMesh(testing::prism(5))};
    const Tessellation t = tessellate(surface, n);
    expect_watertight(t, true);
    // Euler: closed quadrilateral meshes of a sphere have V - E + F = 2, E = 2 F.
    EXPECT_EQ(t.points.size(), t.quads.size() + 2);
    expect_points_of_surface(surface, t);
    for (const Vector3d& normal : t.normals) EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
  }
}

TEST(Tessellation, LeavesOutIsolatedPoints) {
  mesh::MeshArrays arrays = testing::cube();
  arrays.points.insert(arrays.points.begin(), Vector3d(9.0, 9.0, 9.0));
  for (int& v : arrays.face_vertices) ++v;
  const Tessellation t = tessellate(LimitSurface{mesh::ControlMesh(arrays)}, 3);
  EXPECT_EQ(t.points.size(), t.quads.size() + 2);
  for (const Vector3d& p : t.points) EXPECT_LE(p.cwiseAbs().maxCoeff(), 1.0);
}

TEST(Tessellation, KeepsToItsTolerance) {
  SCOPED_TRACE(::testing::Message() << "seed " << kTessellationSeed);
  std::mt19937 random(kTessellationSeed);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < testing::trials(60); ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 32));
    const LimitSurface surface(mesh, trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const double tolerance = (trial % 3 ? 1e-2 : 1e-3) * mesh.size();
    const Tessellation t = tessellate_to_tolerance(surface, tolerance);
    expect_points_of_surface(surface, t);
    int borders = 0;
    const mesh::Topology& cells = surface.cells();
    for (int h = 0; h < cells.half_edge_count(); ++h) borders += cells.twin(h) < 0;
    expect_watertight(t, borders == 0);
    EXPECT_EQ(borders == 0, border_sides(t) == 0);
    const Measured measured = measure(surface, t, 6);
    ASSERT_LE(measured.largest, tolerance) << "trial " << trial;
    // Not many more than it takes: sag goes with the square of divisions, which are whole numbers.
    if (measured.most > 1) {
      EXPECT_GE(measured.largest, 0.2 * tolerance) << "trial " << trial;
    }
  }
}

// The first value is kept for all cells of a sector; others would give the same.
TEST(Tessellation, SharesNormalsWithinSectors) {
  std::mt19937 random(kTessellationSeed + 1);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 100; ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 16));
    const LimitSurface surface(mesh, trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const mesh::Topology& cells = surface.cells();
    const Tessellation t = tessellate(surface, 2);
    constexpr double kPlaces[4][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    // Of each cell the four quadrilaterals hold its corners 0, 1, 3 and 2.
    constexpr int kQuads[] = {0, 1, 3, 2};
    const auto index = [&](int h) { return t.corner_normals[4 * (h / 4) + kQuads[h & 3]][h & 3]; };
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      const auto& [u, v] = kPlaces[h & 3];
      const Vector3d normal = surface.normal(h / 4, u, v);
      ASSERT_LT((t.normals[index(h)] - normal).norm(), 1e-11) << "trial " << trial;
      const int left = mesh::turn_left(cells, h);
      if (left >= 0) {
        ASSERT_EQ(index(h), index(left));
      } else if (const int across = cells.twin(cells.prev(h));
                 across >= 0 && cells.kind_at(h) == mesh::VertexKind::kCrease) {
        ASSERT_NE(index(h), index(across));
      }
    }
  }
}

TEST(Tessellation, RefusesToleranceItCannotKeep) {
  mesh::MeshArrays arrays = testing::fan(5);
  arrays.corners = {0};
  const LimitSurface cone{mesh::ControlMesh(arrays)};
  for (double tolerance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(tessellate_to_tolerance(cone, tolerance), std::invalid_argument);
  }
  try {
    tessellate_to_tolerance(cone, 1e-5);
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    const std::size_t at = message.rfind("als. ");
    ASSERT_NE(at, std::string::npos) << message;
    const double enough = std::stod(message.substr(at + 5));
    EXPECT_NO_THROW(tessellate_to_tolerance(cone, enough)) << message;
    EXPECT_THROW(tessellate_to_tolerance(cone, enough / 4.0), std::invalid_argument);
  }
}

// Flat faces need no division, however unevenly they are parametrised.
TEST(Tessellation, LeavesFlatSidesWhole) {
  const LimitSurface box{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  EXPECT_EQ(tessellate_to_tolerance(box, 1e-6).quads.size(), 24u);
  mesh::MeshArrays arrays = testing::grid(6, 6);
  for (auto& p : arrays.points) p = {std::exp(0.4 * p.x()), std::exp(-0.3 * p.y()), 0.0};
  EXPECT_EQ(tessellate_to_tolerance(LimitSurface{mesh::ControlMesh(arrays)}, 1e-6).quads.size(),
            144u);
}

}  // namespace
}  // namespace hull::surface

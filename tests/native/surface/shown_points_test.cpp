// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/shown_points.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "mesh/tolerances.h"
#include "surface/sampling/tessellation.h"
#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kShownPointsSeed = 22112026;

std::vector<Vector3d> with_some_moved(const std::vector<Vector3d>& points, std::mt19937& random) {
  std::uniform_int_distribution<std::size_t> which(0, points.size() - 1);
  std::uniform_int_distribution<int> how_many(1, 3);
  std::normal_distribution<double> step(0.0, 0.1);
  std::vector<Vector3d> moved = points;
  for (int i = how_many(random); i > 0; --i) {
    moved[which(random)] += Vector3d(step(random), step(random), step(random));
  }
  return moved;
}

// By one move after the other of a few points, everything is as if it were made anew, and cells of
// which no place has moved are known not to have.
TEST(SetPoints, OfAFewEqualsANewSurfaceAndKnowsWhichCellsMoved) {
  SCOPED_TRACE(::testing::Message() << "seed " << kShownPointsSeed);
  std::mt19937 random(kShownPointsSeed);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 30; ++trial) {
    mesh::MeshArrays arrays = testing::random_mesh(random, 10);
    LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    for (int move = 1; move <= 5; ++move) {
      const LimitSurface before = surface;
      arrays.points = with_some_moved(arrays.points, random);
      surface.set_points(arrays.points);
      const LimitSurface anew(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
      ASSERT_EQ(surface.revision(), move);
      int still = 0;
      for (int cell = 0; cell < anew.cell_count(); ++cell) {
        bool same = true;
        for (double u : {0.0, 1e-5, 0.4, 1.0}) {
          for (double v : {0.0, 0.3, 1.0}) {
            const Vector3d place = surface.position(cell, u, v);
            ASSERT_EQ(place, anew.position(cell, u, v));
            ASSERT_EQ(surface.normal(cell, u, v), anew.normal(cell, u, v));
            same = same && place == before.position(cell, u, v);
          }
        }
        if (!same) {
          ASSERT_EQ(surface.moved_at(cell), move) << "cell " << cell;
        }
        if (surface.moved_at(cell) < move) ++still;
      }
      // The meshes are small, but not so small that all of them moves each time.
      if (move == 5 && anew.cell_count() > 400) {
        EXPECT_GT(still, 0);
      }
    }
  }
}

// What ShownPoints promises, from a tessellation that is made anew.
void expect_fresh(const ShownPoints& shown, const LimitSurface& surface, int n, bool mirrored,
                  double unit) {
  const Tessellation fresh = tessellate(surface, n);
  std::vector<Vector3d> images;
  ASSERT_EQ(shown.shared().size(), fresh.points.size());
  const auto expect_at = [&](std::size_t i, const Vector3d& p) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_FLOAT_EQ(shown.coordinates()[3 * i + k], static_cast<float>(p[k] / unit)) << i;
    }
  };
  for (std::size_t i = 0; i < fresh.points.size(); ++i) {
    Vector3d p = fresh.points[i];
    const bool shared = !mirrored || std::abs(p.y()) <= kOnCentrePlane * surface.mesh().size();
    ASSERT_EQ(static_cast<bool>(shown.shared()[i]), shared);
    if (mirrored && shared) p.y() = 0.0;
    expect_at(i, p);
    if (!shared) images.emplace_back(p.x(), -p.y(), p.z());
  }
  ASSERT_EQ(shown.coordinates().size(), 3 * (fresh.points.size() + images.size()));
  for (std::size_t i = 0; i < images.size(); ++i) expect_at(fresh.points.size() + i, images[i]);
}

TEST(ShownPoints, FollowEveryMove) {
  SCOPED_TRACE(::testing::Message() << "seed " << kShownPointsSeed);
  std::mt19937 random(kShownPointsSeed + 1);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 20; ++trial) {
    mesh::MeshArrays arrays = testing::random_mesh(random, 8);
    LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kCatmullClark, cache);
    const bool mirrored = trial % 2 == 0;
    ShownPoints shown(surface, 1 + trial % 5, mirrored, 0.3048);
    for (int move = 0; move < 5; ++move) {
      expect_fresh(shown, surface, 1 + trial % 5, mirrored, 0.3048);
      if (::testing::Test::HasFatalFailure()) return;
      arrays.points = with_some_moved(arrays.points, random);
      surface.set_points(arrays.points);
      EXPECT_TRUE(shown.update());
    }
  }
}

// A strip along the centre plane whose border is pulled off it, and put back.
TEST(ShownPoints, NumberImagesAnewWherePointsLeaveTheCentrePlane) {
  mesh::MeshArrays arrays = testing::grid(8, 3);
  LimitSurface surface{mesh::ControlMesh(arrays)};
  ShownPoints shown(surface, 4, true, 1.0);
  const float* kept = shown.coordinates().data();
  const std::vector<float> before = shown.coordinates();
  std::vector<Vector3d> pulled = arrays.points;
  pulled[4].y() += 0.2;
  surface.set_points(pulled);
  EXPECT_FALSE(shown.update());
  EXPECT_GT(shown.coordinates().size(), before.size());
  expect_fresh(shown, surface, 4, true, 1.0);
  surface.set_points(arrays.points);
  EXPECT_FALSE(shown.update());
  EXPECT_EQ(shown.coordinates(), before);
  EXPECT_TRUE(shown.update());
  EXPECT_EQ(shown.coordinates().data(), kept) << "whoever reads the numbers holds on to them";
}

// A hull that grows by one point at its end: borders by rounding beside the centre plane are on it
// now, though nothing moved there; and off it again.
TEST(ShownPoints, FollowTheSizeThatTheCentrePlaneGoesBy) {
  mesh::MeshArrays arrays = testing::grid(8, 3);
  const double size = mesh::ControlMesh(arrays).size();
  for (int i = 0; i < 5; ++i) arrays.points[i].y() = 3.0 * kOnCentrePlane * size;
  LimitSurface surface{mesh::ControlMesh(arrays)};
  ShownPoints shown(surface, 4, true, 1.0);
  std::vector<Vector3d> grown = arrays.points;
  grown.back().x() += 4.0 * size;
  for (const std::vector<Vector3d>& points : {grown, arrays.points}) {
    surface.set_points(points);
    EXPECT_FALSE(shown.update());
    expect_fresh(shown, surface, 4, true, 1.0);
  }
  EXPECT_TRUE(shown.update());
}

// Which a program compares with what it has.
TEST(ShownPoints, KeepWhatWasShownLastUntilTheUpdate) {
  mesh::MeshArrays arrays = testing::cube();
  LimitSurface surface{mesh::ControlMesh(arrays)};
  ShownPoints shown(surface, 2, false, 1.0);
  const std::vector<float> before = shown.coordinates();
  for (auto& point : arrays.points) point *= 2.0;
  surface.set_points(arrays.points);
  EXPECT_EQ(shown.coordinates(), before);
  shown.update();
  EXPECT_NE(shown.coordinates(), before);
}

TEST(ShownPoints, RefuseUnitsThatAreNone) {
  const LimitSurface surface{mesh::ControlMesh(testing::cube())};
  EXPECT_THROW(ShownPoints(surface, 4, false, 0.0), std::invalid_argument);
  EXPECT_THROW(ShownPoints(surface, 0, false, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace hull::surface

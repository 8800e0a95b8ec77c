// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "surface/sampling/grid_samples.h"
#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kClosestPointSeed = 11212026;

LimitSurface random_surface(std::mt19937& random, int trial, int max_valence,
                            const std::shared_ptr<BasisCache>& cache) {
  return LimitSurface(mesh::ControlMesh(testing::random_mesh(random, max_valence)),
                      trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
}

Vector3d random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

// p near the surface, on it, far off or deep inside, by `kind`.
Vector3d random_query(std::mt19937& random, const LimitSurface& surface, int kind) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int cell = static_cast<int>(unit(random) * surface.cell_count());
  constexpr double kAway[] = {0.0, 1e-9, 0.01, 0.1, 1.0, 100.0};
  return surface.position(cell, unit(random), unit(random)) +
         kAway[kind % 6] * surface.mesh().size() * random_vector(random);
}

TEST(ClosestPoint, IsOnTheSurfaceAtItsCellAndParameters) {
  SCOPED_TRACE(::testing::Message() << "seed " << kClosestPointSeed);
  std::mt19937 random(kClosestPointSeed);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 120; ++trial) {
    const LimitSurface surface = random_surface(random, trial, 12, cache);
    const SurfaceTree tree(surface);
    for (int i = 0; i < 60; ++i) {
      const Vector3d p = random_query(random, surface, i);
      const ClosestPoint at = closest_point(tree, p);
      ASSERT_GE(at.cell, 0);
      ASSERT_LT((surface.position(at.cell, at.u, at.v) - at.point).norm(),
                1e-13 * tree.error_size());
      ASSERT_NEAR(at.distance, (p - at.point).norm(), 1e-15 * (at.distance + tree.error_size()));
      if (i % 6 == 0) {
        ASSERT_LT(at.distance, 1e-13 * tree.error_size());
      }
      ASSERT_LE(at.gap, 1e-13 * tree.error_size()) << "trial " << trial << " query " << i;
    }
  }
}

// The least distance from p by two things that have nothing to do with the tree: a dense grid of
// samples, and coordinate search from the best of them within its cell.
double sampled_distance(const LimitSurface& surface, const GridSamples& samples,
                        const Vector3d& p) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < samples.points.size(); ++k) {
    if ((samples.points[k] - p).squaredNorm() < (samples.points[best] - p).squaredNorm()) best = k;
  }
  const std::size_t row = samples.n + 1, cell = best / (row * row), in_cell = best % (row * row);
  double u = static_cast<double>(in_cell / row) / samples.n;
  double v = static_cast<double>(in_cell % row) / samples.n;
  double distance = (samples.points[best] - p).norm();
  for (double step = 0.5 / samples.n; step > 1e-7;) {
    bool nearer = false;
    for (const auto& [du, dv] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const double to_u = std::clamp(u + du, 0.0, 1.0), to_v = std::clamp(v + dv, 0.0, 1.0);
      const double there = (surface.position(static_cast<int>(cell), to_u, to_v) - p).norm();
      if (there >= distance) continue;
      distance = there;
      u = to_u;
      v = to_v;
      nearer = true;
    }
    if (!nearer) step *= 0.5;
  }
  return distance;
}

TEST(ClosestPoint, HasNothingNearer) {
  SCOPED_TRACE(::testing::Message() << "seed " << kClosestPointSeed);
  std::mt19937 random(kClosestPointSeed + 1);
  const auto cache = std::make_shared<BasisCache>();
  int improved = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const LimitSurface surface = random_surface(random, trial, trial % 10 ? 9 : 40, cache);
    const SurfaceTree tree(surface);
    const GridSamples samples = evaluate_grid(surface, 24, 0);
    for (int i = 0; i < 24; ++i) {
      const Vector3d p = random_query(random, surface, i);
      const double distance = sampled_distance(surface, samples, p);
      const ClosestPoint at = closest_point(tree, p);
      ASSERT_LE(at.distance, distance + at.gap + 1e-15 * (distance + tree.error_size()))
          << "trial " << trial << " query " << i;
      improved += at.distance < distance - 1e-9;
    }
  }
  // The grid alone is not as good, or the test would say little.
  EXPECT_GT(improved, 20);
}

// Cells so folded that one piece has several feet.
TEST(ClosestPoint, HasNothingNearerOnFoldedCells) {
  SCOPED_TRACE(::testing::Message() << "seed " << kClosestPointSeed);
  std::mt19937 random(kClosestPointSeed + 7);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 100; ++trial) {
    mesh::MeshArrays arrays = trial % 2 ? testing::grid(2, 2) : testing::fan(5);
    testing::randomise(arrays, random, 0.0, 0.0, 6.0);
    const LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    const SurfaceTree tree(surface);
    const GridSamples samples = evaluate_grid(surface, 24, 0);
    for (int i = 0; i < 30; ++i) {
      const Vector3d p = random_query(random, surface, 3);
      const double distance = sampled_distance(surface, samples, p);
      const ClosestPoint at = closest_point(tree, p);
      ASSERT_LE(at.distance, distance + at.gap + 1e-15 * (distance + tree.error_size()))
          << "trial " << trial << " query " << i;
    }
  }
}

TEST(ClosestPoint, IsTheFootOfAPerpendicular) {
  SCOPED_TRACE(::testing::Message() << "seed " << kClosestPointSeed);
  std::mt19937 random(kClosestPointSeed + 2);
  const auto cache = std::make_shared<BasisCache>();
  int smooth = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const LimitSurface surface = random_surface(random, trial, 9, cache);
    const SurfaceTree tree(surface);
    for (int i = 0; i < 60; ++i) {
      const Vector3d p = random_query(random, surface, 2 + i % 3);
      const ClosestPoint at = closest_point(tree, p);
      if (at.kind != FootKind::kSmooth) {
        continue;
      }
      ++smooth;
      const SurfaceJet jet = surface.evaluate(at.cell, at.u, at.v, 1);
      const Vector3d r = p - at.point;
      ASSERT_LE(std::abs(r.dot(jet.du)), 1e-10 * jet.du.norm() * tree.size());
      ASSERT_LE(std::abs(r.dot(jet.dv)), 1e-10 * jet.dv.norm() * tree.size());
      const double height = r.dot(surface.normal(at.cell, at.u, at.v));
      if (std::abs(height) > 1e-6) {
        ASSERT_EQ(at.side, height > 0.0 ? 1 : -1);
      }
    }
  }
  EXPECT_GT(smooth, 2000);
}

TEST(ClosestPoint, OfABoxIsThatOfTheClosedForm) {
  const Vector3d low(0.0, -2.0, 0.0), high(5.0, 2.0, 3.0);
  const LimitSurface surface{mesh::ControlMesh(testing::creased_box(5.0, 4.0, 3.0))};
  const SurfaceTree tree(surface);
  std::mt19937 random(kClosestPointSeed + 3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int kinds[3] = {};
  for (int i = 0; i < 3000; ++i) {
    Vector3d p(12.0 * unit(random) - 3.5, 10.0 * unit(random) - 5.0, 8.0 * unit(random) - 2.5);
    if (i % 5 == 0) p.x() = 2.5;  // the middle, at the same distance from two sides
    const Vector3d inside = p.cwiseMax(low).cwiseMin(high);
    const bool is_inside = inside == p;
    const double expected =
        is_inside ? std::min((p - low).minCoeff(), (high - p).minCoeff()) : (p - inside).norm();
    const ClosestPoint at = closest_point(tree, p);
    ASSERT_NEAR(at.distance, expected, 1e-14 * tree.size());
    ASSERT_EQ(at.side, is_inside ? -1 : 1);
    int outside = 0;
    for (int k = 0; k < 3; ++k) outside += p[k] < low[k] || p[k] > high[k];
    if (!is_inside) {
      ASSERT_LT((at.point - inside).norm(), 1e-13 * tree.size());
      const FootKind kind = outside == 1   ? FootKind::kSmooth
                            : outside == 2 ? FootKind::kCrease
                                           : FootKind::kKnot;
      ASSERT_EQ(at.kind, kind);
    }
    ++kinds[static_cast<int>(at.kind)];
  }
  for (int count : kinds) EXPECT_GT(count, 100);
}

TEST(ClosestPoint, BeyondABorderHasNoSide) {
  const LimitSurface surface{mesh::ControlMesh(testing::grid(4, 4))};
  const SurfaceTree tree(surface);
  const ClosestPoint beside = closest_point(tree, {2.3, -1.0, 0.0});
  EXPECT_NEAR(beside.distance, 1.0, 1e-14);
  EXPECT_EQ(beside.kind, FootKind::kCrease);
  EXPECT_EQ(beside.side, 0);
  EXPECT_EQ(closest_point(tree, {2.3, -1.0, 0.5}).side, 1);
  EXPECT_EQ(closest_point(tree, {2.3, 1.0, -0.5}).side, -1);
}

TEST(ClosestPoint, AtKnotsAndOverThem) {
  const auto cache = std::make_shared<BasisCache>();
  for (int n : {3, 5, 6, 8, 17, 40, 64}) {
    mesh::MeshArrays arrays = testing::fan(n);
    arrays.points[0].z() = 1.0;
    for (bool is_cone : {false, true}) {
      if (is_cone) arrays.corners = {0};
      const LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
      const SurfaceTree tree(surface);
      const Vector3d knot = surface.position(0, 0.0, 0.0);
      const ClosestPoint on = closest_point(tree, knot);
      EXPECT_LT(on.distance, 1e-13 * tree.size()) << n;
      if (!is_cone) continue;
      // Over a cone's tip that is the highest of the mesh nothing is nearer.
      const ClosestPoint over = closest_point(tree, knot + Vector3d(0.0, 0.0, 3.0));
      EXPECT_NEAR(over.distance, 3.0, 1e-14 * tree.size()) << n;
      EXPECT_EQ(over.kind, FootKind::kKnot) << n;
      EXPECT_EQ(over.side, 0) << n;
    }
  }
}

// Points of the medial axis, at nearly the same distance from much of the surface.
TEST(ClosestPoint, OfTheMiddleOfARoundBodyTakesBoundedWork) {
  mesh::MeshArrays arrays = testing::cube();
  // Twice subdivided and put on a sphere: as round as a mesh of this size gets.
  for (int level = 0; level < 3; ++level) {
    const LimitSurface surface{mesh::ControlMesh(arrays)};
    const mesh::Topology& cells = surface.cells();
    mesh::MeshArrays finer;
    finer.points = surface.layout().refine(surface.mesh().topology(), surface.mesh().points());
    finer.points.resize(cells.vertex_count());
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      finer.face_vertices.push_back(cells.origin(h));
    }
    finer.face_sizes.assign(cells.face_count(), 4);
    for (Vector3d& p : finer.points) p.normalize();
    arrays = finer;
  }
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  const SurfaceTree tree(surface);
  const GridSamples samples = evaluate_grid(surface, 8, 0);
  for (const Vector3d& p :
       {Vector3d(0.0, 0.0, 0.0), Vector3d(1e-12, 0.0, 0.0), Vector3d(1e-4, 2e-5, 0.0)}) {
    double least = 2.0, most = 0.0;
    for (const Vector3d& q : samples.points) {
      least = std::min(least, (q - p).norm());
      most = std::max(most, (q - p).norm());
    }
    ASSERT_LT(most - least, 1e-2);  // else it is not round
    const ClosestPoint at = closest_point(tree, p);
    EXPECT_LE(at.distance, least + 1e-15);
    EXPECT_LE(at.gap, 1e-4);
    EXPECT_GE(at.distance, least - 1e-3);
    // All of the surface is beyond this radius, by next to nothing.
    const double radius = at.distance - at.gap - 1e-12;
    EXPECT_EQ(closest_point(tree, p, radius).cell, -1);
  }
}

TEST(ClosestPoint, TurnsAndScalesWithTheMesh) {
  std::mt19937 random(kClosestPointSeed + 4);
  const Eigen::AngleAxisd turn(0.7, Vector3d(1.0, 2.0, -0.5).normalized());
  constexpr double kScale = 37.0;
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 40; ++trial) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 8);
    mesh::MeshArrays moved = arrays;
    for (auto& p : moved.points) p = kScale * (turn * p);
    const LimitSurface a(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    const LimitSurface b(mesh::ControlMesh(moved), Scheme::kBiermann, cache);
    const SurfaceTree tree_a(a), tree_b(b);
    for (int i = 0; i < 30; ++i) {
      const Vector3d p = random_query(random, a, i);
      const double expected = kScale * closest_point(tree_a, p).distance;
      const double found = closest_point(tree_b, kScale * (turn * p)).distance;
      ASSERT_NEAR(found, expected, 1e-13 * tree_b.error_size() + 1e-15 * expected);
    }
  }
}

TEST(ClosestPoint, ManyAreTheSameAsOneByOne) {
  std::mt19937 random(kClosestPointSeed + 5);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 20; ++trial) {
    const LimitSurface surface = random_surface(random, trial, 8, cache);
    const SurfaceTree tree(surface);
    std::vector<Vector3d> points;
    for (int i = 0; i < 200; ++i) points.push_back(random_query(random, surface, i));
    const std::vector<ClosestPoint> many = closest_points(tree, points);
    ASSERT_EQ(many.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ClosestPoint one = closest_point(tree, points[i]);
      ASSERT_NEAR(many[i].distance, one.distance, one.gap + 1e-15 * one.distance);
    }
  }
}

TEST(ClosestPoint, KeepsToTheSearchRadius) {
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::grid(3, 3)))};
  EXPECT_EQ(closest_point(tree, {1.5, 1.5, 2.0}, 1.9).cell, -1);
  EXPECT_TRUE(std::isinf(closest_point(tree, {1.5, 1.5, 2.0}, 1.9).distance));
  EXPECT_DOUBLE_EQ(closest_point(tree, {1.5, 1.5, 2.0}, 2.1).distance, 2.0);
  const auto some = closest_points(tree, {{1.5, 1.5, 2.0}, {1.5, 1.5, 0.5}, {9.0, 9.0, 9.0}}, 1.0);
  EXPECT_EQ(some[0].cell, -1);
  EXPECT_DOUBLE_EQ(some[1].distance, 0.5);
  EXPECT_EQ(some[2].cell, -1);
}

TEST(ClosestPoint, NamesWhatIsWrong) {
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::cube()))};
  const double nan = std::nan("");
  EXPECT_THROW(closest_point(tree, {0.0, nan, 0.0}), std::invalid_argument);
  EXPECT_THROW(closest_point(tree, Vector3d::Zero(), -1.0), std::invalid_argument);
  EXPECT_THROW(closest_point(tree, Vector3d::Zero(), nan), std::invalid_argument);
  try {
    closest_points(tree, {Vector3d::Zero(), {0.0, 0.0, INFINITY}});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("points[1]"), std::string::npos);
  }
}

TEST(SurfaceTree, FollowsTheSurfaceOnlyWhenRefitted) {
  std::mt19937 random(kClosestPointSeed + 6);
  mesh::MeshArrays arrays = testing::fan(7);
  LimitSurface surface{mesh::ControlMesh(arrays)};
  SurfaceTree tree(surface);
  const Vector3d p(0.3, 0.2, 4.0);
  const double before = closest_point(tree, p).distance;
  testing::randomise(arrays, random, 0.0, 0.0, 0.5);
  surface.set_points(arrays.points);
  EXPECT_EQ(closest_point(tree, p).distance, before);
  tree.refit(surface);
  const SurfaceTree anew(surface);
  EXPECT_NE(closest_point(tree, p).distance, before);
  EXPECT_NEAR(closest_point(tree, p).distance, closest_point(anew, p).distance, 1e-13);
  const LimitSurface other{mesh::ControlMesh(arrays)};
  EXPECT_THROW(tree.refit(other), std::invalid_argument);
}

}  // namespace
}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/ray_hits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "surface/queries/closest_point.h"
#include "surface/sampling/grid_samples.h"
#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kRayHitsSeed = 11212027;

// The point at distance t along side k (half-edge 4 cell + k) of a cell.
Eigen::Vector2d on_side(int k, double t) {
  const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
  return places[k];
}

Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

// A closed mesh of random kind, tags and positions.
mesh::MeshArrays random_body(std::mt19937& random) {
  const auto draw = [&random](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const int kind = draw(0, 2);
  const int n = draw(0, 9) == 0 ? draw(3, 30) : draw(3, 8);
  mesh::MeshArrays mesh = kind == 0   ? testing::cube()
                          : kind == 1 ? testing::prism(n)
                                      : testing::double_pyramid(n);
  constexpr double kCreases[] = {0.0, 0.1, 0.3, 0.7};
  testing::randomise(mesh, random, kCreases[draw(0, 3)], draw(0, 2) ? 0.0 : 0.1, 0.2);
  return mesh;
}

double nearest(const std::vector<RayHit>& hits, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const RayHit& hit : hits) least = std::min(least, (hit.point - p).norm());
  return least;
}

TEST(RayHits, AreOnTheRayAndOnTheSurface) {
  SCOPED_TRACE(::testing::Message() << "seed " << kRayHitsSeed);
  std::mt19937 random(kRayHitsSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cache = std::make_shared<BasisCache>();
  int hits_seen = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 12)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const SurfaceTree tree(surface);
    for (int i = 0; i < 60; ++i) {
      const int cell = static_cast<int>(unit(random) * surface.cell_count());
      const double u = unit(random), v = unit(random);
      const Vector3d aim = surface.position(cell, u, v), direction = random_direction(random);
      const Ray ray{aim - 5.0 * unit(random) * direction, 7.0 * direction};
      const std::vector<RayHit> hits = all_ray_hits(tree, ray);
      for (const RayHit& hit : hits) {
        ++hits_seen;
        ASSERT_LT((surface.position(hit.cell, hit.u, hit.v) - hit.point).norm(),
                  1e-13 * tree.error_size());
        const Vector3d on_ray = ray.origin + hit.t * direction;
        ASSERT_LT((on_ray - hit.point).norm(), 2e-13 * tree.error_size());
        ASSERT_LT(closest_point(tree, hit.point).distance, 1e-13 * tree.error_size());
      }
      // Nearly along the surface the place is worse conditioned.
      const double sine = std::abs(surface.normal(cell, u, v).dot(direction));
      if (sine > 1e-3) {
        ASSERT_LT(nearest(hits, aim), 1e-9 * tree.error_size()) << "trial " << trial;
      }
      const std::optional<RayHit> first = first_ray_hit(tree, ray);
      ASSERT_EQ(first.has_value(), !hits.empty());
      if (first) {
        ASSERT_NEAR(first->t, hits.front().t, 1e-9);
      }
    }
  }
  EXPECT_GT(hits_seen, 6000);
}

// Rays from outside through anything of a closed body leave it again, however they meet sides,
// corners and knots of cells.
TEST(RayHits, OfClosedBodiesComeInPairsAndNeverSlipThrough) {
  SCOPED_TRACE(::testing::Message() << "seed " << kRayHitsSeed);
  std::mt19937 random(kRayHitsSeed + 1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cache = std::make_shared<BasisCache>();
  int rays = 0, odd = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(random_body(random)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const SurfaceTree tree(surface);
    constexpr double kPlaces[] = {0.0, 1e-12, 0.25, 0.5, 0.7, 1.0 - 1e-9};
    for (int i = 0; i < 60; ++i) {
      const int h = static_cast<int>(unit(random) * surface.cells().half_edge_count());
      const Eigen::Vector2d uv = on_side(h & 3, kPlaces[i % 6]);
      const Vector3d aim = surface.position(h / 4, uv.x(), uv.y());
      const Vector3d direction = random_direction(random);
      const std::vector<RayHit> hits = all_ray_hits(tree, {aim - 20.0 * direction, direction});
      ASSERT_FALSE(hits.empty()) << "trial " << trial << " ray " << i;
      ASSERT_LT(nearest(hits, aim), 1e-6) << "trial " << trial << " ray " << i;
      for (std::size_t k = 1; k < hits.size(); ++k) ASSERT_LT(hits[k - 1].t, hits[k].t);
      ++rays;
      // At a knuckle a ray may touch the edge only.
      const bool on_knuckle =
          surface.cells().is_crease(h) || kPlaces[i % 6] < 1e-6 || kPlaces[i % 6] > 1.0 - 1e-6;
      if (on_knuckle) continue;
      odd += hits.size() % 2;
    }
    for (int i = 0; i < 60; ++i) {
      const Vector3d direction = random_direction(random);
      const Vector3d through(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
      odd += all_ray_hits(tree, {2.0 * through - 20.0 * direction, direction}).size() % 2;
      ++rays;
    }
  }
  EXPECT_GE(rays, 18000);
  EXPECT_EQ(odd, 0);
}

// Cells so folded that a ray meets one piece many times: as often as the triangles of a dense grid
// of samples, seen along the ray.
TEST(RayHits, OfFoldedCellsAreAsManyAsThoseOfSmallTriangles) {
  SCOPED_TRACE(::testing::Message() << "seed " << kRayHitsSeed);
  std::mt19937 random(kRayHitsSeed + 4);
  const auto cache = std::make_shared<BasisCache>();
  constexpr int kGrid = 40;
  const auto cross = [](const Vector3d& a, const Vector3d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  int differ = 0, rays = 0;
  std::size_t most = 0;
  for (int trial = 0; trial < 20; ++trial) {
    mesh::MeshArrays arrays = trial % 2 ? testing::grid(3, 3) : testing::fan(5);
    testing::randomise(arrays, random, 0.0, 0.0, trial % 2 ? 3.0 : 6.0);
    const LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    const SurfaceTree tree(surface);
    const GridSamples samples = evaluate_grid(surface, kGrid, 0);
    for (int i = 0; i < 10; ++i) {
      const Vector3d direction = random_direction(random);
      const Vector3d origin = random_direction(random) + Vector3d(1.5, 1.5, 0.0) * (trial % 2);
      const Vector3d x = direction.unitOrthogonal(), y = direction.cross(x);
      Eigen::Matrix3d frame;
      frame << x.transpose(), y.transpose(), direction.transpose();
      std::vector<Vector3d> seen;
      for (const Vector3d& p : samples.points) seen.push_back(frame * (p - origin));
      std::size_t expected = 0;
      const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        const double ab = cross(seen[a], seen[b]), bc = cross(seen[b], seen[c]);
        const double ca = cross(seen[c], seen[a]);
        expected += (ab >= 0) == (bc >= 0) && (bc >= 0) == (ca >= 0);
      };
      for (int cell = 0; cell < surface.cell_count(); ++cell) {
        for (int a = 0; a < kGrid; ++a) {
          for (int b = 0; b < kGrid; ++b) {
            const std::size_t corners[] = {samples.index(cell, a, b), samples.index(cell, a + 1, b),
                                           samples.index(cell, a + 1, b + 1),
                                           samples.index(cell, a, b + 1)};
            triangle(corners[0], corners[1], corners[2]);
            triangle(corners[0], corners[2], corners[3]);
          }
        }
      }
      Ray ray{origin, direction};
      ray.t_min = -1000.0;
      const std::size_t found = all_ray_hits(tree, ray).size();
      most = std::max(most, found);
      ++rays;
      differ += found != expected;
    }
  }
  // Triangles err where a ray passes near a fold or border.
  EXPECT_LE(differ, rays / 25);
  EXPECT_GE(most, 7u);
}

// A border point far away: lines of equal u and of equal v run nearly alike there, so that a place
// beside the axis by rounding alone is far beside it in u and v.
TEST(RayHits, AtBordersOfNarrowCells) {
  SCOPED_TRACE(::testing::Message() << "seed " << kRayHitsSeed);
  std::mt19937 random(kRayHitsSeed + 7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (double away : {30.0, 1e3, 1e4, 1e5}) {
    mesh::MeshArrays mesh = testing::grid(1, 2);
    mesh.points[0] = {-away, -2.0, -2.0};
    mesh.points[3] = {-1.5, 1.8, -2.0};
    const LimitSurface surface{mesh::ControlMesh(mesh)};
    const SurfaceTree tree(surface);
    const mesh::Topology& cells = surface.cells();
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      if (cells.twin(h) >= 0) continue;
      for (double t : {0.0, 1e-3, unit(random)}) {
        const Eigen::Vector2d uv = on_side(h & 3, t);
        const Vector3d aim = surface.position(h / 4, uv.x(), uv.y());
        for (int i = 0; i < 100; ++i) {
          const Vector3d direction = random_direction(random);
          if (std::abs(surface.normal(h / 4, uv.x(), uv.y()).dot(direction)) < 0.1) continue;
          const Ray ray{aim - away * unit(random) * direction, direction};
          ASSERT_LT(nearest(all_ray_hits(tree, ray), aim), 1e-6 * tree.error_size())
              << "away " << away << ", half-edge " << h << " at " << t << ", ray " << i;
        }
      }
    }
  }
}

// A body that is large but for a small part: in the small one pieces are flat to the tolerance, and
// what crosses a piece beside such a flat one is the beginning of the ray's run along it.
TEST(RayHits, WhereTheyAreAimedAtSmallPartsOfLargeBodies) {
  SCOPED_TRACE(::testing::Message() << "seed " << kRayHitsSeed);
  std::mt19937 random(kRayHitsSeed + 8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int aimed = 0;
  for (int trial = 0; trial < 15; ++trial) {
    mesh::MeshArrays arrays = testing::prism(3 + trial % 4);
    testing::randomise(arrays, random, 0.3, 0.1, 0.4);
    const double size = std::pow(10.0, 6.0 + 2.9 * unit(random));
    for (int far = trial % 3; far >= 0; --far) {
      arrays.points[static_cast<std::size_t>(unit(random) * arrays.points.size())] =
          size * random_direction(random);
    }
    const LimitSurface surface{mesh::ControlMesh(arrays)};
    const SurfaceTree tree(surface);
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      for (const Eigen::Vector2d& uv : {Eigen::Vector2d(0.0, 0.0), {0.0, unit(random)}}) {
        const Vector3d aim = surface.position(cell, uv.x(), uv.y());
        for (int i = 0; i < 5; ++i) {
          const Vector3d direction = random_direction(random);
          if (std::abs(surface.normal(cell, uv.x(), uv.y()).dot(direction)) < 0.1) continue;
          const Ray ray{aim - 1.5 * size * direction, direction};
          const std::vector<RayHit> hits = all_ray_hits(tree, ray);
          ASSERT_LT(nearest(hits, aim), 1e-6 * tree.error_size()) << "trial " << trial;
          const std::optional<RayHit> first = first_ray_hit(tree, ray);
          ASSERT_TRUE(first.has_value()) << "trial " << trial << ", cell " << cell;
          ASSERT_NEAR(first->t, hits.front().t, 1e-11 * tree.error_size());
          ++aimed;
        }
      }
    }
  }
  EXPECT_GT(aimed, 1000);
}

TEST(RayHits, OfABoxAreThoseOfTheClosedForm) {
  const Vector3d low(0.0, -2.0, 0.0), high(5.0, 2.0, 3.0);
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::creased_box(5.0, 4.0, 3.0)))};
  std::mt19937 random(kRayHitsSeed + 2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int crossed = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d direction = random_direction(random);
    const Vector3d through(6.0 * unit(random) - 0.5, 5.0 * unit(random) - 2.5,
                           4.0 * unit(random) - 0.5);
    const Vector3d origin = through - 10.0 * direction;
    double from = -1e300, to = 1e300;
    for (int k = 0; k < 3; ++k) {
      const double a = (low[k] - origin[k]) / direction[k];
      const double b = (high[k] - origin[k]) / direction[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    const std::vector<RayHit> hits = all_ray_hits(tree, {origin, direction});
    if (from > to) {
      ASSERT_TRUE(hits.empty());
      continue;
    }
    ++crossed;
    ASSERT_EQ(hits.size(), 2u);
    ASSERT_NEAR(hits[0].t, from, 1e-11);
    ASSERT_NEAR(hits[1].t, to, 1e-11);
    ASSERT_FALSE(hits[0].grazing || hits[1].grazing);
  }
  EXPECT_GT(crossed, 1000);
}

TEST(RayHits, ThroughEdgesAndCornersOfABoxCountOnce) {
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::creased_box(2.0, 2.0, 2.0)))};
  const Vector3d corner(0.0, -1.0, 0.0), opposite(2.0, 1.0, 2.0);
  const Vector3d along = (opposite - corner).normalized();
  const std::vector<RayHit> diagonal = all_ray_hits(tree, {corner - along, along});
  ASSERT_EQ(diagonal.size(), 2u);
  EXPECT_NEAR(diagonal[0].t, 1.0, 1e-12);
  EXPECT_NEAR(diagonal[1].t, 1.0 + std::sqrt(12.0), 1e-12);
  // Through the middles of two opposite edges, where cells meet too.
  const std::vector<RayHit> edges = all_ray_hits(tree, {{1.0, -2.0, -1.0}, {0.0, 1.0, 1.0}});
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_NEAR(edges[0].t, std::sqrt(2.0), 1e-12);
  // Through the middle of a face, where four cells meet.
  const std::vector<RayHit> middle = all_ray_hits(tree, {{1.0, 0.0, -1.0}, {0.0, 0.0, 3.0}});
  ASSERT_EQ(middle.size(), 2u);
  EXPECT_NEAR(middle[0].t, 1.0, 1e-12);
  EXPECT_NEAR(middle[1].t, 3.0, 1e-12);
}

TEST(RayHits, AlongAFlatSideAreItsEnds) {
  const SurfaceTree box{LimitSurface(mesh::ControlMesh(testing::creased_box(5.0, 4.0, 3.0)))};
  // In the top, across cells and slantwise; and along an edge.
  const struct {
    Vector3d origin, direction;
    double from, to;
  } rays[] = {{{-1.0, 0.3, 3.0}, {1.0, 0.0, 0.0}, 1.0, 6.0},
              {{-1.0, 0.0, 3.0}, {1.0, 0.0, 0.0}, 1.0, 6.0},
              {{-1.0, 0.0, 3.0}, {1.0, 0.25, 0.0}, std::hypot(1.0, 0.25), std::hypot(6.0, 1.5)},
              {{-1.0, -2.0, 3.0}, {1.0, 0.0, 0.0}, 1.0, 6.0}};
  for (const auto& ray : rays) {
    const std::vector<RayHit> hits = all_ray_hits(box, {ray.origin, ray.direction});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].t, ray.from, 1e-10);
    EXPECT_NEAR(hits[1].t, ray.to, 1e-10);
    EXPECT_TRUE(hits[0].grazing && hits[1].grazing);
    const std::optional<RayHit> first = first_ray_hit(box, {ray.origin, ray.direction});
    ASSERT_TRUE(first.has_value());
    EXPECT_NEAR(first->t, ray.from, 1e-10);
  }
}

// A trough: curved one way, straight the other.
TEST(RayHits, AlongAStraightLineOfACurvedSideAreItsEnds) {
  mesh::MeshArrays arrays = testing::grid(5, 5);
  for (Vector3d& p : arrays.points) p.z() = 0.2 * std::pow(p.y() - 2.5, 2);
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  const SurfaceTree tree(surface);
  for (double v : {0.3, 0.77, 1.0}) {
    const Vector3d on_line = surface.position(4 * 7, 0.4, v);
    const Vector3d origin = on_line - Vector3d(20.0, 0.0, 0.0);
    const std::vector<RayHit> hits = all_ray_hits(tree, {origin, Vector3d::UnitX()});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].point.x(), 0.0, 1e-9);
    EXPECT_NEAR(hits[1].point.x(), 5.0, 1e-9);
    EXPECT_TRUE(hits[0].grazing && hits[1].grazing);
  }
}

TEST(RayHits, ThatTouchAreGrazing) {
  // A dome, its highest line crosswise.
  mesh::MeshArrays arrays = testing::grid(6, 6);
  for (Vector3d& p : arrays.points) {
    p.z() = -0.1 * (std::pow(p.x() - 3.0, 2) + std::pow(p.y() - 3.0, 2));
  }
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  const SurfaceTree tree(surface);
  const Vector3d top = surface.position(4 * 14, 1.0, 1.0);
  const Vector3d beside = surface.position(4 * 14 + 1, 0.3, 0.6);
  for (const Vector3d& at : {top, beside}) {
    const Vector3d normal = closest_point(tree, at).kind == FootKind::kSmooth
                                ? surface.normal(4 * 14 + (at == top ? 0 : 1),
                                                 at == top ? 1.0 : 0.3, at == top ? 1.0 : 0.6)
                                : Vector3d::UnitZ();
    const Vector3d along = normal.cross(Vector3d(0.3, 1.0, 0.1)).normalized();
    const std::vector<RayHit> touching = all_ray_hits(tree, {at - 9.0 * along, along});
    ASSERT_FALSE(touching.empty());
    EXPECT_LT(nearest(touching, at), 1e-5);
    EXPECT_TRUE(touching.front().grazing);
    const std::vector<RayHit> over = all_ray_hits(tree, {at - 9.0 * along + 1e-11 * normal, along});
    EXPECT_TRUE(over.empty());
    const std::vector<RayHit> under = all_ray_hits(tree, {at - 9.0 * along - 1e-6 * normal, along});
    EXPECT_EQ(under.size(), 2u);
  }
}

TEST(RayHits, KeepToTheirStretch) {
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::creased_box(2.0, 2.0, 2.0)))};
  Ray ray{{0.7, 0.1, -1.0}, {0.0, 0.0, 1.0}};
  ray.t_min = 1.5;
  EXPECT_NEAR(first_ray_hit(tree, ray)->t, 3.0, 1e-13);
  ray.t_max = 2.0;
  EXPECT_FALSE(first_ray_hit(tree, ray).has_value());
  EXPECT_TRUE(all_ray_hits(tree, ray).empty());
  ray.t_min = -10.0;
  EXPECT_EQ(all_ray_hits(tree, ray).size(), 1u);
  ray.origin.z() = 5.0;
  EXPECT_EQ(all_ray_hits(tree, ray).size(), 2u);
}

TEST(RayHits, TurnAndScaleWithTheMesh) {
  std::mt19937 random(kRayHitsSeed + 3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Eigen::AngleAxisd turn(1.1, Vector3d(-1.0, 0.4, 2.0).normalized());
  constexpr double kScale = 0.01;
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 40; ++trial) {
    const mesh::MeshArrays arrays = random_body(random);
    mesh::MeshArrays moved = arrays;
    for (auto& p : moved.points) p = kScale * (turn * p);
    const SurfaceTree a{LimitSurface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache)};
    const SurfaceTree b{LimitSurface(mesh::ControlMesh(moved), Scheme::kBiermann, cache)};
    for (int i = 0; i < 50; ++i) {
      const Vector3d direction = random_direction(random);
      const Vector3d origin = 0.5 * random_direction(random) - 10.0 * direction;
      const std::vector<RayHit> hits = all_ray_hits(a, {origin, direction});
      const std::vector<RayHit> hits_moved =
          all_ray_hits(b, {kScale * (turn * origin), turn * direction});
      ASSERT_EQ(hits.size(), hits_moved.size());
      for (std::size_t k = 0; k < hits.size(); ++k) {
        ASSERT_NEAR(hits_moved[k].t, kScale * hits[k].t, 1e-10 * b.error_size());
      }
    }
  }
}

TEST(RayHits, NameWhatIsWrong) {
  const SurfaceTree tree{LimitSurface(mesh::ControlMesh(testing::cube()))};
  const double nan = std::nan("");
  const Vector3d zero = Vector3d::Zero(), x = Vector3d::UnitX();
  EXPECT_THROW(first_ray_hit(tree, {{nan, 0.0, 0.0}, x}), std::invalid_argument);
  EXPECT_THROW(first_ray_hit(tree, {zero, {INFINITY, 0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(all_ray_hits(tree, {zero, zero}), std::invalid_argument);
  EXPECT_THROW(all_ray_hits(tree, {zero, x, nan}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::surface

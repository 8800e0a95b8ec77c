// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/limit_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "surface/refined_mesh.h"
#include "test_meshes.h"
#include "trials.h"

namespace hull::surface {
namespace {

constexpr unsigned kLimitSurfaceSeed = 7102026;

// The point at distance t along side k (half-edge 4 cell + k) of a cell.
Eigen::Vector2d point_on_side(int k, double t) {
  const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
  return places[k];
}

// Every cell that shares a side computes the same points there. Rounding of the local eigenbases
// grows slowly with the valence; 1e-13 of the size is what is promised up to 64.
TEST(LimitSurface, IsTheSameFromBothSidesOfEverySide) {
  SCOPED_TRACE(::testing::Message() << "seed " << kLimitSurfaceSeed);
  std::mt19937 random(kLimitSurfaceSeed);
  const auto cache = std::make_shared<BasisCache>();
  const double places[] = {0.0, 1e-9, 0.01, 0.3, 0.5, 0.77, 1.0};
  for (int trial = 0; trial < testing::trials(2000); ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 64));
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const LimitSurface surface(mesh, scheme, cache);
    const mesh::Topology& cells = surface.cells();
    double worst = 0.0;
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      const int g = cells.twin(h);
      if (g < h) continue;
      for (double t : places) {
        const Eigen::Vector2d a = point_on_side(h & 3, t), b = point_on_side(g & 3, 1.0 - t);
        worst = std::max(
            worst,
            (surface.position(h / 4, a.x(), a.y()) - surface.position(g / 4, b.x(), b.y())).norm());
      }
    }
    ASSERT_LT(worst, 1e-13 * mesh.size()) << "trial " << trial;
  }
}

// The once-subdivided mesh, taken as a control mesh with its tags, has the same surface.
TEST(LimitSurface, IsTheSameFromTheSubdividedMesh) {
  std::mt19937 random(kLimitSurfaceSeed + 1);
  const auto cache = std::make_shared<BasisCache>();
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 60; ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 9));
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const LimitSurface surface(mesh, scheme, cache);
    const LimitSurface finer(refined_mesh(surface), scheme, cache);
    ASSERT_EQ(finer.mesh().topology().face_count(), surface.cell_count());
    for (int i = 0; i < 40; ++i) {
      const int cell = static_cast<int>(unit(random) * surface.cell_count());
      // Lower left quarter of the cell: corner 0 of the finer mesh's face.
      const double u = 0.5 * unit(random), v = 0.5 * unit(random);
      const Vector3d a = surface.position(cell, u, v);
      const Vector3d b = finer.position(4 * cell, 2.0 * u, 2.0 * v);
      ASSERT_LT((a - b).norm(), 1e-13 * mesh.size()) << "trial " << trial << " cell " << cell;
    }
  }
}

TEST(LimitSurface, DerivativesAgreeWithDifferences) {
  std::mt19937 random(kLimitSurfaceSeed + 2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cache = std::make_shared<BasisCache>();
  constexpr double kStep = 1e-5;
  for (int trial = 0; trial < 60; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 9)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    for (int i = 0; i < 20; ++i) {
      const int cell = static_cast<int>(unit(random) * surface.cell_count());
      // Away from knot lines, where third derivatives jump.
      const double u = 0.51 + 0.2 * unit(random), v = 0.26 + 0.2 * unit(random);
      const SurfaceJet at = surface.evaluate(cell, u, v, 2);
      const SurfaceJet right = surface.evaluate(cell, u + kStep, v, 1);
      const SurfaceJet left = surface.evaluate(cell, u - kStep, v, 1);
      const SurfaceJet above = surface.evaluate(cell, u, v + kStep, 1);
      const SurfaceJet below = surface.evaluate(cell, u, v - kStep, 1);
      // Truncation is of the order of step² times third derivatives, rounding 1e-16 / step.
      const double tolerance = 2e-8;
      const auto differ = [&](const Vector3d& high, const Vector3d& low, const Vector3d& value) {
        return ((high - low) / (2.0 * kStep) - value).norm();
      };
      ASSERT_LT(differ(right.point, left.point, at.du), tolerance);
      ASSERT_LT(differ(above.point, below.point, at.dv), tolerance);
      ASSERT_LT(differ(right.du, left.du, at.duu), tolerance);
      ASSERT_LT(differ(above.du, below.du, at.duv), tolerance);
      ASSERT_LT(differ(above.dv, below.dv, at.dvv), tolerance);
      ASSERT_LT(std::abs(surface.normal(cell, u, v).dot(at.du)), 1e-12 * at.du.norm());
    }
  }
}

// Independent evaluation of a regular grid: clamped borders by reflected points, Cox–de Boor in the
// two directions.
double cox_de_boor(int i, int degree, double t) {  // uniform knots …, -1, 0, 1, …
  if (degree == 0) return t >= i && t < i + 1 ? 1.0 : 0.0;
  return (t - i) / degree * cox_de_boor(i, degree - 1, t) +
         (i + degree + 1 - t) / degree * cox_de_boor(i + 1, degree - 1, t);
}

TEST(LimitSurface, IsATensorProductBSplineOnARegularGrid) {
  constexpr int kM = 5, kN = 4;
  mesh::MeshArrays arrays = testing::grid(kM, kN);
  std::mt19937 random(kLimitSurfaceSeed + 3);
  testing::randomise(arrays, random, 0.0, 0.0, 0.4);
  const auto reflected = [](int i, int last, const auto& get) -> Vector3d {
    if (i < 0) return 2.0 * get(0) - get(1);
    if (i > last) return 2.0 * get(last) - get(last - 1);
    return get(i);
  };
  const auto point = [&](int i, int j) {
    return reflected(j, kN, [&](int row) {
      return reflected(
          i, kM, [&](int column) -> Vector3d { return arrays.points[row * (kM + 1) + column]; });
    });
  };
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    const int face = static_cast<int>(unit(random) * kM * kN);
    const double u = unit(random), v = unit(random);
    const double x = face % kM + 0.5 * u, y = face / kM + 0.5 * v;
    Vector3d expected = Vector3d::Zero();
    for (int j = -1; j <= kN + 1; ++j) {
      for (int i = -1; i <= kM + 1; ++i) {
        expected += point(i, j) * cox_de_boor(i - 2, 3, x) * cox_de_boor(j - 2, 3, y);
      }
    }
    // Corner 0 of the face is its lower left one.
    ASSERT_LT((surface.position(4 * face, u, v) - expected).norm(), 1e-14);
  }
}

TEST(LimitSurface, NormalsAgreeAroundSmoothVertices) {
  std::mt19937 random(kLimitSurfaceSeed + 4);
  const auto cache = std::make_shared<BasisCache>();
  for (int n = 3; n <= 40; n += n < 10 ? 1 : 10) {
    mesh::MeshArrays arrays = testing::fan(n);
    testing::randomise(arrays, random, 0.0, 0.0, 0.05);
    const LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    const Vector3d first = surface.normal(0, 0.0, 0.0);
    EXPECT_NEAR(first.norm(), 1.0, 1e-15);
    EXPECT_GT(first.z(), 0.0);
    for (int face = 0; face < n; ++face) {
      EXPECT_LT((surface.normal(4 * face, 0.0, 0.0) - first).norm(), 1e-12) << "valence " << n;
      if (n == 4) continue;  // regular, so without a corner basis
      // The surface is C¹ there: normals nearby approach it as the ratio of the third to the second
      // eigenvalue does to the power of the level, 333 at 1e-100.
      const DominantSpectrum& spectrum = surface.layout().basis(0).spectrum();
      const auto& blocks = spectrum.blocks;
      const double third = blocks.size() > 2 ? blocks[2].eigenvalue : spectrum.rest;
      const double ratio = third / blocks[1].eigenvalue;
      EXPECT_LT((surface.normal(4 * face, 1e-100, 1e-100) - first).norm(),
                1e-9 + 10.0 * std::pow(ratio, 332))
          << "valence " << n;
    }
  }
}

// Down to the smallest numbers there are. So near, no point differs from the corner, the normal by
// rounding only: next to a corner it changes like a power of the distance.
TEST(LimitSurface, PlacesNextToAnIrregularKnotAreThatOfTheKnot) {
  SCOPED_TRACE(::testing::Message() << "seed " << kLimitSurfaceSeed + 5);
  std::mt19937 random(kLimitSurfaceSeed + 5);
  const auto cache = std::make_shared<BasisCache>();
  int knots = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 9)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const double size = surface.mesh().size();
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      if (!surface.is_irregular_knot(cell, 0.0, 0.0)) continue;
      ++knots;
      const Vector3d corner = surface.position(cell, 0.0, 0.0);
      const Vector3d normal = surface.normal(cell, 0.0, 0.0);
      for (double t : {5e-324, 1e-310, 1e-300, 1e-200, 1e-160}) {
        for (const Eigen::Vector2d& place :
             {Eigen::Vector2d(t, 0.0), Eigen::Vector2d(0.5 * t, t)}) {
          SCOPED_TRACE(::testing::Message()
                       << "trial " << trial << " cell " << cell << " at " << t);
          const SurfaceJet jet = surface.evaluate(cell, place.x(), place.y(), 2);
          ASSERT_LT((jet.point - corner).norm(), 1e-13 * size);
          ASSERT_TRUE(jet.du.allFinite() && jet.dv.allFinite() && jet.duu.allFinite() &&
                      jet.duv.allFinite() && jet.dvv.allFinite());
          ASSERT_LT((surface.normal(cell, place.x(), place.y()) - normal).norm(), 1e-12);
        }
      }
    }
  }
  EXPECT_GT(knots, 100);
}

TEST(LimitSurface, ConeTipsHaveNoNormal) {
  mesh::MeshArrays arrays = testing::fan(5);
  arrays.corners = {0};
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  EXPECT_EQ(surface.normal(0, 0.0, 0.0), Vector3d::Zero());
  EXPECT_EQ(surface.position(0, 0.0, 0.0), arrays.points[0]);
}

// A closed mesh of faces subdivided once by Catmull and Clark's masks, written out, its first point
// kept. Faces in the order of Topology::refined().
mesh::MeshArrays subdivided_around_a_tip(const mesh::MeshArrays& mesh) {
  const mesh::Topology t = mesh::ControlMesh(mesh).topology();
  const auto face_point = [&](int h) {
    Vector3d sum = Vector3d::Zero();
    const int f = t.face(h);
    for (int i = 0; i < t.face_size(f); ++i) {
      sum += mesh.points[t.origin(t.first_half_edge(f) + i)] / t.face_size(f);
    }
    return sum;
  };
  const auto end = [&](int h) { return mesh.points[t.origin(t.next(h))]; };
  const int n = t.vertex_count(), faces = t.face_count();
  mesh::MeshArrays fine;
  fine.points.resize(n + faces + t.edge_count(), Vector3d::Zero());
  for (int v = 0; v < n; ++v) {
    fine.points[v] = mesh.points[v];
    if (v == 0) continue;
    Vector3d around = Vector3d::Zero();
    int valence = 0;
    for (int h = 0; h < t.half_edge_count(); ++h) {
      if (t.origin(h) != v) continue;
      around += face_point(h) + end(h);
      ++valence;
    }
    fine.points[v] = around / (valence * valence) + mesh.points[v] * ((valence - 2.0) / valence);
  }
  for (int h = 0; h < t.half_edge_count(); ++h) {
    fine.points[n + t.face(h)] = face_point(h);
    fine.points[n + faces + t.edge(h)] =
        0.25 * (mesh.points[t.origin(h)] + end(h) + face_point(h) + face_point(t.twin(h)));
    fine.face_sizes.push_back(4);
    for (int v : {t.origin(h), n + faces + t.edge(h), n + t.face(h), n + faces + t.edge(t.prev(h))})
      fine.face_vertices.push_back(v);
  }
  fine.corners = {0};
  return fine;
}

// Where a corner is tagged without creases there are no sectors to take weights from: its edges
// keep 1/4 under both schemes.
TEST(LimitSurface, EdgesOfConeTipsKeepTheSmoothWeights) {
  std::mt19937 random(kLimitSurfaceSeed + 6);
  mesh::MeshArrays arrays = testing::cube();
  testing::randomise(arrays, random, 0.0, 0.0, 0.2);
  arrays.corners = {0};
  const LimitSurface biermann{mesh::ControlMesh(arrays)};
  const LimitSurface catmull_clark(mesh::ControlMesh(arrays), Scheme::kCatmullClark);
  const LimitSurface fine{mesh::ControlMesh(subdivided_around_a_tip(arrays))};
  ASSERT_EQ(biermann.mesh().topology().kind(0), mesh::VertexKind::kCone);
  for (int cell = 0; cell < biermann.cell_count(); ++cell) {
    for (double u : {0.0, 0.01, 0.3, 0.5}) {
      const Vector3d here = biermann.position(cell, u, 0.4);
      EXPECT_EQ(here, catmull_clark.position(cell, u, 0.4));
      EXPECT_LT((here - fine.position(4 * cell, 2.0 * u, 0.8)).norm(), 1e-14);
    }
  }
}

TEST(LimitSurface, MovesAndTurnsWithItsMesh) {
  std::mt19937 random(kLimitSurfaceSeed + 5);
  const Eigen::AngleAxisd turn(0.7, Vector3d(1.0, 2.0, -0.5).normalized());
  const Vector3d shift(100.0, -20.0, 3.0);
  for (int trial = 0; trial < 30; ++trial) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 8);
    mesh::MeshArrays moved = arrays;
    for (auto& p : moved.points) p = turn * p + shift;
    const LimitSurface a{mesh::ControlMesh(arrays)}, b{mesh::ControlMesh(moved)};
    for (int cell = 0; cell < a.cell_count(); ++cell) {
      const Vector3d expected = turn * a.position(cell, 0.2, 0.05) + shift;
      ASSERT_LT((b.position(cell, 0.2, 0.05) - expected).norm(), 1e-13 * shift.norm());
    }
  }
}

}  // namespace
}  // namespace hull::surface

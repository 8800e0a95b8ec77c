// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "analysis/fairness/cell_places.h"
#include "analysis/fairness/curve_fairness.h"
#include "analysis/fairness/flat_regions.h"
#include "analysis/fairness/flatness.h"
#include "analysis/fairness/light_lines.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr int kFairnessMeshes = 150;

Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector3d v = Vector3d::Zero();
  for (double& x : v) x = normal(random);
  return v.normalized();
}

TEST(CellPlaces, AreOnePointOfTheSurface) {
  std::mt19937 random(1);
  for (int mesh = 0; mesh < kFairnessMeshes; ++mesh) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const double near = 1e-12 * surface.mesh().size();
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      for (const auto& uv :
           {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1.0, 1.0),
            Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.3, 0.0), Eigen::Vector2d(1.0, 0.3),
            Eigen::Vector2d(0.3, 1.0), Eigen::Vector2d(0.0, 0.3)}) {
        const Vector3d p = surface.position(cell, uv.x(), uv.y());
        for (const surface::CellPlace& at : cell_places(surface.cells(), cell, uv)) {
          ASSERT_LE((surface.position(at.cell, at.u, at.v) - p).norm(), near);
        }
      }
      EXPECT_EQ(cell_places(surface.cells(), cell, {0.4, 0.7}).size(), 1u);
      // All cells around the cell's own corner, each once.
      const int h = 4 * cell;
      std::size_t around = 0;
      for (int other = 0; other < surface.cells().half_edge_count(); ++other) {
        around += surface.cells().origin(other) == surface.cells().origin(h) ? 1 : 0;
      }
      EXPECT_EQ(cell_places(surface.cells(), cell, {0.0, 0.0}).size(), around);
    }
  }
}

TEST(CurveFairness, SamplesOfRandomSectionsAreInTheirPlanes) {
  std::mt19937 random(2);
  int curves = 0;
  for (int i = 0; i < kFairnessMeshes; ++i) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const double size = surface.mesh().size();
    const Vector3d normal = random_direction(random);
    const Plane plane{normal, normal.dot(surface.position(0, 0.37, 0.59))};
    const auto judged = section_fairness(surface, {plane}, SectionOptions{1e-4 * size, {}}, {});
    for (const CurveFairness& curve : judged[0]) {
      ++curves;
      ASSERT_EQ(curve.samples.size(), curve.arc_lengths.size());
      ASSERT_EQ(curve.starts.back(), static_cast<int>(curve.samples.size()));
      double chords = 0.0;
      for (std::size_t k = 0; k < curve.samples.size(); ++k) {
        const CurveSample& at = curve.samples[k];
        ASSERT_TRUE(at.point.allFinite() && at.curvature.allFinite());
        ASSERT_LE(std::abs(plane.height(at.point)), 1e-9 * size);
        if (k > 0) chords += (at.point - curve.samples[k - 1].point).norm();
      }
      EXPECT_LE(chords, curve.length * (1.0 + 1e-4) + 1e-6 * size);
      for (const CurveMark& mark : curve.marks) {
        ASSERT_TRUE(mark.point.allFinite() && std::isfinite(mark.curvature));
        ASSERT_LE(std::abs(plane.height(mark.point)), 1e-9 * size);
        ASSERT_TRUE(mark.arc_length >= 0.0 && mark.arc_length <= curve.length * (1.0 + 1e-12));
      }
    }
  }
  // Every plane goes through its surface. What meshes there are depends on the compiler, which
  // chooses the order in which a call's arguments are drawn.
  EXPECT_GE(curves, kFairnessMeshes);
}

TEST(CurveFairness, RandomFeaturesHaveFiniteMarks) {
  std::mt19937 random(3);
  for (int i = 0; i < kFairnessMeshes; ++i) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    for (const CurveFairness& curve : feature_fairness(surface, random_direction(random), {})) {
      ASSERT_GT(curve.length, 0.0);
      for (const CurveSample& at : curve.samples) ASSERT_TRUE(at.point.allFinite());
      for (const CurveMark& mark : curve.marks) ASSERT_TRUE(mark.point.allFinite());
    }
  }
}

TEST(LevelCurves, OfRandomSurfacesAreExact) {
  std::mt19937 random(4);
  int points = 0, points_off = 0;
  for (int i = 0; i < kFairnessMeshes; ++i) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const Vector3d direction = random_direction(random);
    const double size = surface.mesh().size();
    for (const LevelCurve& curve : isophotes(surface, direction, {0.6, 1.3}, {6, 1e-3 * size})) {
      const double level = std::cos(curve.level);
      for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const double u = curve.uv[k].x(), v = curve.uv[k].y();
        ASSERT_LE((surface.position(curve.cells[k], u, v) - curve.points[k]).norm(), 1e-11 * size);
        // Beside cone tips and cusps the normal turns within any distance.
        const double off = surface.normal(curve.cells[k], u, v).dot(direction) - level;
        points_off += std::abs(off) > 1e-9 ? 1 : 0;
        ++points;
      }
      ASSERT_EQ(curve.points.size(), curve.cells.size());
    }
  }
  EXPECT_GT(points, 20 * kFairnessMeshes);
  EXPECT_LE(points_off, points / 200);
}

TEST(FlatRegions, BordersOfRandomFlatSheetsEncloseTheirAreas) {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    mesh::MeshArrays arrays = testing::fan(std::uniform_int_distribution<int>(3, 9)(random));
    testing::randomise(arrays, random, 0.1, 0.0, 0.05);
    for (Vector3d& p : arrays.points) p.z() = 0.0;
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    const auto regions = flat_regions(surface, {}, 1e-9);
    ASSERT_EQ(regions.size(), 1u);
    ASSERT_EQ(regions[0].borders.size(), 1u);
    double doubled = 0.0;
    for (const auto& c : regions[0].borders[0].cubics) {
      constexpr int kParts = 400;
      Vector3d last = c[0];
      for (int k = 1; k <= kParts; ++k) {
        const double t = static_cast<double>(k) / kParts, s = 1.0 - t;
        const Vector3d p =
            s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
        doubled += last.x() * p.y() - last.y() * p.x();
        last = p;
      }
    }
    EXPECT_NEAR(0.5 * doubled, regions[0].area, 1e-3 * regions[0].area);
  }
}

// All cells of a cube laid flat have an irregular corner.
TEST(Flatness, OfAFlatPartThereIsAPoint) {
  mesh::MeshArrays arrays = testing::cube();
  for (Vector3d& p : arrays.points) p.z() = 1.0;
  const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  const Plane plane{Vector3d::UnitZ(), 1.0};
  const Flatness found = flatness(surface, flat_part_of_faces(surface, {0}), plane, 1e-6);
  EXPECT_LT(found.surface_distance, 1e-12);
  EXPECT_NEAR(found.surface_point.z(), 1.0, 1e-12);
}

TEST(Flatness, LargestDistanceIsAboveAllSamples) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < kFairnessMeshes; ++i) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const Vector3d normal = random_direction(random);
    const Plane plane{normal, 0.2};
    std::vector<int> faces;
    for (int f = 0; f < surface.mesh().topology().face_count(); ++f) faces.push_back(f);
    const Flatness result = flatness(surface, flat_part_of_faces(surface, faces), plane, 1e-6);
    double sampled = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const int cell = static_cast<int>(unit(random) * surface.cell_count());
      sampled = std::max(
          sampled, std::abs(plane.height(surface.position(cell, unit(random), unit(random)))));
    }
    EXPECT_GE(result.surface_distance, sampled - 1e-8);
    EXPECT_LE(result.surface_distance, sampled + 0.3);
    EXPECT_NEAR(std::abs(plane.height(result.surface_point)), result.surface_distance, 1e-12);
  }
}

}  // namespace
}  // namespace hull::analysis

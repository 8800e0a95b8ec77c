// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/thin_plate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kThinPlateSeed = 22112026;

double energy_of(const surface::LimitSurface& surface) {
  return thin_plate_energy(surface, surface::PieceWeights(surface), surface.mesh().points());
}

// A sphere has 8π whatever its size. Surfaces near one have a little more: points of three faces,
// where a surface of this kind is no sphere, count the same however fine the mesh.
TEST(ThinPlate, OfASphere) {
  mesh::MeshArrays mesh = testing::cube();
  for (int step = 0; step < 3; ++step) {
    for (auto& p : mesh.points) p = 7.0 * p.normalized();
    const mesh::ControlMesh control(mesh);
    const double sphere = 8.0 * std::numbers::pi;
    EXPECT_NEAR(energy_of(surface::LimitSurface(control)), sphere, 0.03 * sphere);
    // The next: once subdivided, which is smooth but for rounding.
    const mesh::Topology finer = control.topology().refined();
    mesh::MeshArrays next;
    const surface::LimitSurface surface(control);
    next.points.resize(finer.vertex_count());
    for (int cell = 0; cell < finer.face_count(); ++cell) {
      const int h = 4 * cell;
      std::vector<int> corners;
      const double u[] = {0.0, 1.0, 1.0, 0.0}, v[] = {0.0, 0.0, 1.0, 1.0};
      for (int k = 0; k < 4; ++k) {
        corners.push_back(finer.origin(h + k));
        next.points[corners.back()] = surface.position(cell, u[k], v[k]);
      }
      testing::add_face(next, corners);
    }
    mesh = next;
  }
}

// A cylinder of parabolic section, whose integral is elementary; rows unevenly spaced along it cost
// nothing.
TEST(ThinPlate, OfAParabolicCylinder) {
  mesh::MeshArrays mesh = testing::grid(12, 6);
  const auto height = [](double x) { return 0.05 * (x - 6.0) * (x - 6.0); };
  for (auto& p : mesh.points) p = {p.x(), p.y() + 0.05 * p.y() * p.y(), height(p.x())};
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  // By the surface's own derivatives, summed up at very many places.
  double wanted = 0.0;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int i = 0; i < 40; ++i) {
      const surface::SurfaceJet jet = surface.evaluate(cell, (i + 0.5) / 40, 0.5, 2);
      const Vector3d normal = jet.du.cross(jet.dv);
      const double area = normal.norm();
      // Of the two curvatures one is 0: the other is twice the mean.
      const double E = jet.du.dot(jet.du), F = jet.du.dot(jet.dv), G = jet.dv.dot(jet.dv);
      const double L = jet.duu.dot(normal) / area, M = jet.duv.dot(normal) / area,
                   N = jet.dvv.dot(normal) / area;
      const double curvature = (E * N - 2.0 * F * M + G * L) / (area * area);
      double across = 0.0;
      for (int j = 0; j < 8; ++j) {
        const surface::SurfaceJet there = surface.evaluate(cell, (i + 0.5) / 40, (j + 0.5) / 8, 1);
        across += there.du.cross(there.dv).norm() / 8;
      }
      wanted += curvature * curvature * across / 40;
    }
  }
  EXPECT_NEAR(energy_of(surface), wanted, 2e-3 * wanted);
}

// Turning, moving and scaling the surface leaves the energy; moves that keep it rigid cost nothing
// but where it turns.
TEST(ThinPlate, IsOfTheShapeAlone) {
  std::mt19937 random(kThinPlateSeed);
  for (int trial = 0; trial < 20; ++trial) {
    const mesh::MeshArrays mesh = testing::random_mesh(random, 12);
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const double energy = energy_of(surface);
    mesh::MeshArrays other = mesh;
    const Eigen::AngleAxisd turn(1.1, Vector3d(1.0, 2.0, -0.5).normalized());
    for (auto& p : other.points) p = 3.0 * (turn * p) + Vector3d(5.0, -7.0, 2.0);
    EXPECT_NEAR(energy_of(surface::LimitSurface(mesh::ControlMesh(other))), energy, 1e-8 * energy);
    const std::vector<Vector3d> shift(mesh.points.size(), Vector3d(1.0, 2.0, 3.0));
    EXPECT_LT(thin_plate_energy(surface, surface::PieceWeights(surface), shift),
              1e-12 * (1.0 + energy));
  }
}

// The least of the energy alone, border points held: the equations' step is a minimum of the
// quadratic form that the energy is with the metric as it is.
TEST(ThinPlate, StepLowersTheEnergyMost) {
  std::mt19937 random(kThinPlateSeed);
  mesh::MeshArrays mesh = testing::grid(5, 4);
  std::normal_distribution<double> noise(0.0, 0.3);
  for (auto& p : mesh.points) p.z() += noise(random);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const surface::PieceWeights pieces(surface);
  MoveLimits limits;
  const mesh::Topology& t = surface.mesh().topology();
  for (int h = 0; h < t.half_edge_count(); ++h) {
    if (t.twin(h) < 0) limits.locked.push_back(t.origin(h));
  }
  const auto freedoms = freedoms_within(limits, t.vertex_count());
  FitEquations equations(t.vertex_count());
  std::vector<Vector3d> values = mesh.points;
  add_thin_plate(surface, pieces, values, 1.0, equations);
  const auto moves = equations.solve(MoveSpace({limits}, t.vertex_count()), 0.0);
  ASSERT_TRUE(moves.has_value());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += (*moves)[i];
  const double least = thin_plate_energy(surface, pieces, values);
  EXPECT_LT(least, 0.9 * energy_of(surface));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (freedoms[i].count == 0) {
      EXPECT_TRUE((*moves)[i].isZero(0.0));
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (double step : {-1e-3, 1e-3}) {
        std::vector<Vector3d> other = values;
        other[i][axis] += step;
        EXPECT_GT(thin_plate_energy(surface, pieces, other), least);
      }
    }
  }
}

}  // namespace
}  // namespace hull::modelling

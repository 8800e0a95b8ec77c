// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/surface_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "surface/limit_surface.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kSurfaceEnergySeed = 23112026;
constexpr double kPi = std::numbers::pi;

std::vector<int> pieces_of(const surface::PieceWeights& weights) {
  std::vector<int> pieces;
  for (int i = 0; i < weights.piece_count(); ++i) pieces.push_back(i);
  return pieces;
}

// A torus of m x n quadrilaterals. Control points are pushed out so that their limits, sums with
// the weights 1, 4, 1 over 6 along both ways round, lie on it.
surface::LimitSurface torus(double large, double small, int m, int n) {
  const double a = (2.0 + std::cos(2.0 * kPi / m)) / 3.0, b = (2.0 + std::cos(2.0 * kPi / n)) / 3.0;
  mesh::MeshArrays mesh;
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = 2.0 * kPi * i / m, v = 2.0 * kPi * j / n;
      const double r = (large + small * std::cos(v) / b) / a;
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v) / b);
    }
  }
  const auto at = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      testing::add_face(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return surface::LimitSurface(mesh::ControlMesh(mesh));
}

// With R and r: ∫ κ1 κ2 dA is 0, so ∫ κ1² + κ2² dA is that of the squared sum,
// 4 π² R² / (r √(R² - r²)). Of ∇h only dκ2/de1 is not zero,
// three times: 3 ∫ (R sin v)² / (r (R + r cos v)³) dv du = 6 π² R² / (r (R² - r²)^(3/2)).
TEST(SurfaceEnergy, OfATorus) {
  const double large = 5.0, small = 2.0;
  const double under = large * large - small * small;
  const double curvature = 4.0 * kPi * kPi * large * large / (small * std::sqrt(under));
  const double variation = 6.0 * kPi * kPi * large * large / (small * std::pow(under, 1.5));
  double before = 0.0;
  for (int n : {10, 20, 40}) {
    const surface::LimitSurface surface = torus(large, small, 2 * n, n);
    EXPECT_NEAR(fair_energy(surface, FairEnergy::kCurvature), curvature, 3.0 / (n * n) * curvature);
    // Third derivatives of a cubic spline are met to the first order in the distance of knots, and
    // their squares to the second.
    const double error = std::abs(fair_energy(surface, FairEnergy::kVariation) - variation);
    EXPECT_LT(error, 20.0 / (n * n) * variation);
    if (before > 0.0) {
      EXPECT_LT(error, before / 3.5);
    }
    before = error;
  }
}

// A tube of n quadrilaterals round and m along, open at its ends: 2 π L / r, and no variation.
TEST(SurfaceEnergy, OfACylinder) {
  const double r = 3.0;
  const int m = 4, n = 48;
  mesh::MeshArrays mesh;
  const double b = (2.0 + std::cos(2.0 * kPi / n)) / 3.0;
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double v = 2.0 * kPi * j / n;
      mesh.points.emplace_back(1.7 * i, r / b * std::cos(v), r / b * std::sin(v));
    }
  }
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const int k = (j + 1) % n;
      testing::add_face(mesh, {i * n + j, (i + 1) * n + j, (i + 1) * n + k, i * n + k});
    }
  }
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const double wanted = 2.0 * kPi * 1.7 * m / r;
  EXPECT_NEAR(fair_energy(surface, FairEnergy::kCurvature), wanted, 3e-3 * wanted);
  // Of the order of the square of the knots' distance: 0.39 / 3 round.
  EXPECT_LT(fair_energy(surface, FairEnergy::kVariation), 1e-2 * wanted / (r * r));
}

// The curvature's energy is that of the thin plate, whose derivatives are to the same metric then.
TEST(SurfaceEnergy, OfCurvatureIsThatOfTheThinPlate) {
  SCOPED_TRACE(::testing::Message() << "seed " << kSurfaceEnergySeed);
  std::mt19937 random(kSurfaceEnergySeed);
  for (int trial = 0; trial < 12; ++trial) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 8))};
    const double plate = fair_energy(surface, FairEnergy::kThinPlate);
    EXPECT_NEAR(fair_energy(surface, FairEnergy::kCurvature), plate, 1e-9 * plate) << trial;
  }
}

// Turned, moved and scaled: the curvature's energy stays, the variation's goes with 1 / length².
TEST(SurfaceEnergy, IsOfTheShapeAlone) {
  SCOPED_TRACE(::testing::Message() << "seed " << kSurfaceEnergySeed);
  std::mt19937 random(kSurfaceEnergySeed);
  for (int trial = 0; trial < 12; ++trial) {
    mesh::MeshArrays mesh = testing::random_mesh(random, 8);
    const surface::LimitSurface before{mesh::ControlMesh(mesh)};
    const Eigen::AngleAxisd turn(1.1, Vector3d(1.0, 2.0, -0.5).normalized());
    for (auto& p : mesh.points) p = 3.0 * (turn * p) + Vector3d(5.0, -7.0, 2.0);
    const surface::LimitSurface after{mesh::ControlMesh(mesh)};
    const double curvature = fair_energy(before, FairEnergy::kCurvature);
    const double variation = fair_energy(before, FairEnergy::kVariation);
    EXPECT_NEAR(fair_energy(after, FairEnergy::kCurvature), curvature, 1e-8 * curvature) << trial;
    EXPECT_NEAR(9.0 * fair_energy(after, FairEnergy::kVariation), variation, 1e-8 * variation)
        << trial;
  }
}

// Derivatives of residuals, by differences across both sides.
TEST(SurfaceEnergy, DerivativesAreExact) {
  SCOPED_TRACE(::testing::Message() << "seed " << kSurfaceEnergySeed);
  std::mt19937 random(kSurfaceEnergySeed);
  mesh::MeshArrays mesh = testing::grid(3, 3);
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  for (auto& p : mesh.points) {
    for (double& x : p) x += noise(random);
  }
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const surface::PieceWeights weights(surface);
  for (const FairEnergy energy : {FairEnergy::kCurvature, FairEnergy::kVariation}) {
    const SurfaceEnergy sums(weights, pieces_of(weights), energy);
    for (std::size_t k = 0; k < sums.places().size(); k += 7) {
      const EnergyPlace& place = sums.places()[k];
      const SurfaceEnergy::Linear linear = sums.linear(place, mesh.points);
      const double size = linear.derivatives.cwiseAbs().maxCoeff();
      const std::vector<int>& which = sums.points_of(place);
      for (std::size_t i = 0; i < which.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          const double step = 1e-5;
          std::vector<Vector3d> ahead = mesh.points, behind = mesh.points;
          ahead[which[i]][axis] += step;
          behind[which[i]][axis] -= step;
          const Eigen::VectorXd slope =
              (sums.linear(place, ahead).residuals - sums.linear(place, behind).residuals) /
              (2.0 * step);
          // Of the third order by the step squared, and rounding over the step.
          EXPECT_LT(
              (slope - linear.derivatives.col(3 * static_cast<Eigen::Index>(i) + axis)).norm(),
              1e-6 * size);
        }
      }
    }
  }
}

}  // namespace
}  // namespace hull::modelling

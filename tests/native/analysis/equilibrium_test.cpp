// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "analysis/stability/potential_energy.h"
#include "analysis/stability/water_at_volume.h"
#include "barges.h"

namespace hull::analysis {
namespace {

constexpr double kVolume = testing::kBargeLength * testing::kBargeBeam * testing::kBargeDraft;
constexpr double kBM = testing::kBargeBeam * testing::kBargeBeam / 12.0 / testing::kBargeDraft;

// A box barge in fresh water.
class BoxBarge : public ::testing::Test {
 protected:
  surface::LimitSurface surface{mesh::ControlMesh(testing::barge(
      testing::box_section(testing::kBargeBeam, testing::kBargeDepth), testing::kBargeLength))};
  HullBody body{surface, false};

  LoadCase load(double x, double y, double z) const { return {kVolume, {x, y, z}, 1.0}; }
};

using Equilibria = BoxBarge;

TEST_F(Equilibria, Upright) {
  EquilibriumOptions options;
  options.start.draft_at = 0.5 * testing::kBargeLength;
  const Equilibrium e = equilibrium(body, load(0.5 * testing::kBargeLength, 0.0, 2.5), options);
  EXPECT_EQ(e.status, EquilibriumStatus::kStable) << e.message;
  EXPECT_FALSE(e.left);
  EXPECT_NEAR(e.position.draft, testing::kBargeDraft, 1e-10);
  EXPECT_NEAR(e.position.trim, 0.0, 1e-11);
  EXPECT_NEAR(e.position.heel, 0.0, 1e-11);
  EXPECT_NEAR(e.gm_transverse, 0.5 * testing::kBargeDraft + kBM - 2.5, 1e-11);
  EXPECT_NEAR(e.gm_longitudinal,
              0.5 * testing::kBargeDraft +
                  testing::kBargeLength * testing::kBargeLength / 12.0 / testing::kBargeDraft - 2.5,
              1e-10);
}

// By the moment of the wet section, which is independent of the descent.
TEST_F(Equilibria, HeeledAndTrimmed) {
  for (double y : {-0.8, 0.3, 1.5}) {
    const Equilibrium e = equilibrium(body, load(0.5 * testing::kBargeLength, y, 2.5));
    ASSERT_EQ(e.status, EquilibriumStatus::kStable) << e.message;
    EXPECT_NEAR(testing::section_lever(
                    testing::box_section(testing::kBargeBeam, testing::kBargeDepth),
                    testing::kBargeBeam * testing::kBargeDraft, {y, 2.5}, e.position.heel),
                0.0, 1e-9);
    EXPECT_GT(-y * e.position.heel, 0.0);
    EXPECT_LE(e.iterations, 12);
  }
  for (double x : {9.0, 10.2, 12.5}) {
    const Equilibrium e = equilibrium(body, load(x, 0.0, 2.5));
    ASSERT_EQ(e.status, EquilibriumStatus::kStable) << e.message;
    // Trim positive by the stern is to x what heel positive to starboard is to y.
    EXPECT_NEAR(
        testing::section_lever(testing::box_section(testing::kBargeLength, testing::kBargeDepth),
                               testing::kBargeLength * testing::kBargeDraft,
                               {x - 0.5 * testing::kBargeLength, 2.5}, e.position.trim),
        0.0, 1e-9);
    EXPECT_NEAR(e.draft(0.0) - e.draft(testing::kBargeLength),
                testing::kBargeLength * std::tan(e.position.trim), 1e-10);
    EXPECT_NEAR(e.draft(e.position.draft_at), e.position.draft, 1e-12);
  }
}

// tan² φ = -2 GM / BM (wall-sided formula).
TEST_F(Equilibria, AngleOfLoll) {
  constexpr double kGM = -0.05;
  const LoadCase top_heavy =
      load(0.5 * testing::kBargeLength, 0.0, 0.5 * testing::kBargeDraft + kBM - kGM);
  const Equilibrium e = equilibrium(body, top_heavy);
  ASSERT_EQ(e.status, EquilibriumStatus::kStable) << e.message;
  EXPECT_NEAR(std::tan(e.position.heel), std::sqrt(-2.0 * kGM / kBM), 1e-8);
  ASSERT_TRUE(e.left);
  EXPECT_NEAR(e.left->position.heel, 0.0, 1e-11);
  EXPECT_NEAR(e.left->gm_transverse, kGM, 1e-11);
  EquilibriumOptions stay;
  stay.leave_unstable = false;
  const Equilibrium upright = equilibrium(body, top_heavy, stay);
  EXPECT_EQ(upright.status, EquilibriumStatus::kUnstable);
  EXPECT_NEAR(upright.position.heel, 0.0, 1e-11);
  EXPECT_NE(upright.message.find("transverse metacentric height is -0.05"), std::string::npos)
      << upright.message;
  // A start to port leads to the rest on that side.
  EquilibriumOptions port;
  port.start.heel = -0.05;
  EXPECT_NEAR(equilibrium(body, top_heavy, port).position.heel, -e.position.heel, 1e-8);
}

TEST_F(Equilibria, NeutralWithoutMetacentricHeight) {
  const Equilibrium e =
      equilibrium(body, load(0.5 * testing::kBargeLength, 0.0, 0.5 * testing::kBargeDraft + kBM));
  EXPECT_EQ(e.status, EquilibriumStatus::kNeutral) << e.message;
  EXPECT_NE(e.message.find("heeling"), std::string::npos) << e.message;
}

TEST_F(Equilibria, HeldTrimAndHeel) {
  EquilibriumOptions held;
  held.start.heel = 0.2;
  held.start.trim = 0.1;
  held.free_trim = held.free_heel = false;
  const LoadCase off = load(11.0, -0.3, 2.5);
  const Equilibrium both = equilibrium(body, off, held);
  EXPECT_EQ(both.status, EquilibriumStatus::kStable) << both.message;
  EXPECT_EQ(both.position.heel, 0.2);
  EXPECT_EQ(both.position.trim, 0.1);
  EXPECT_NEAR(both.immersion.volume, kVolume, 1e-8);
  held.free_heel = true;
  const Equilibrium trim_held = equilibrium(body, off, held);
  EXPECT_EQ(trim_held.status, EquilibriumStatus::kStable) << trim_held.message;
  EXPECT_EQ(trim_held.position.trim, 0.1);
  const Vector3d arm = off.centre_of_gravity - trim_held.immersion.centre_of_buoyancy;
  EXPECT_NEAR(arm.dot(starboard_direction(0.1, trim_held.position.heel)), 0.0, 1e-9);
  held.free_heel = false;
  held.free_trim = true;
  const Equilibrium heel_held = equilibrium(body, off, held);
  EXPECT_EQ(heel_held.position.heel, 0.2);
  const Vector3d along = off.centre_of_gravity - heel_held.immersion.centre_of_buoyancy;
  EXPECT_NEAR(along.dot(forward_direction(heel_held.position.trim, 0.2)), 0.0, 1e-9);
}

TEST_F(Equilibria, SinksOrIsNoLoad) {
  const Equilibrium e = equilibrium(body, {1000.0, {10.0, 0.0, 2.0}, 1.0});
  EXPECT_EQ(e.status, EquilibriumStatus::kSinks);
  EXPECT_NE(e.message.find("1000 t"), std::string::npos) << e.message;
  EXPECT_NE(e.message.find("800 t"), std::string::npos) << e.message;
  EXPECT_THROW(equilibrium(body, {0.0, {10.0, 0.0, 2.0}, 1.0}), std::invalid_argument);
  EXPECT_THROW(equilibrium(body, {-1.0, {10.0, 0.0, 2.0}, 1.0}), std::invalid_argument);
  EXPECT_THROW(equilibrium(body, {1.0, {10.0, 0.0, 2.0}, 0.0}), std::invalid_argument);
  EXPECT_THROW(equilibrium(body, {1.0, {NAN, 0.0, 2.0}, 1.0}), std::invalid_argument);
  EquilibriumOptions on_end;
  on_end.start.trim = 0.5 * std::numbers::pi;
  EXPECT_THROW(equilibrium(body, load(10.0, 0.0, 2.0), on_end), std::invalid_argument);
}

TEST_F(Equilibria, FloodsThroughAnOpening) {
  mesh::MeshArrays mesh = testing::barge(
      testing::box_section(testing::kBargeBeam, testing::kBargeDepth), testing::kBargeLength);
  mesh.face_sizes.erase(mesh.face_sizes.begin() + 2);  // the deck
  mesh.face_vertices.erase(mesh.face_vertices.begin() + 8, mesh.face_vertices.begin() + 12);
  const surface::LimitSurface undecked{mesh::ControlMesh(mesh)};
  const HullBody open(undecked, false, Openings::kOpen);
  EXPECT_EQ(equilibrium(open, load(10.0, 0.0, 2.5)).status, EquilibriumStatus::kStable);
  const Equilibrium listing = equilibrium(open, load(10.0, -2.5, 2.5));
  EXPECT_EQ(listing.status, EquilibriumStatus::kFloods) << listing.message;
  EXPECT_NE(listing.message.find("y = -4 m, z = 5 m"), std::string::npos) << listing.message;
  EXPECT_EQ(equilibrium(open, {1000.0, {10.0, 0.0, 2.0}, 1.0}).status, EquilibriumStatus::kSinks);
}

// Wherever she starts, upside down included, she ends at rest.
TEST_F(Equilibria, FromAnyStart) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    EquilibriumOptions options;
    options.start.heel = std::numbers::pi * unit(random);
    options.start.trim = 1.2 * unit(random);
    const LoadCase any{400.0 + 395.0 * unit(random),
                       {10.0 + 4.0 * unit(random), unit(random), 2.5 + unit(random)},
                       1.0};
    const Equilibrium e = equilibrium(body, any, options);
    EXPECT_EQ(e.status, EquilibriumStatus::kStable) << "trial " << trial << ": " << e.message;
    EXPECT_LE(e.iterations, 40) << "trial " << trial;
  }
}

// The gradient and the second derivatives of the energy that the descent relies on.
TEST(FloatingDescent, DerivativesAreThoseOfTheEnergy) {
  std::mt19937 random(42);
  mesh::MeshArrays mesh = testing::cube();
  testing::randomise(mesh, random, 0.0, 0.0, 0.2);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody body(surface, false);
  constexpr double kWanted = 1.4;
  const Vector3d gravity(0.1, -0.05, 0.2);
  const double trim = 0.15, heel = -0.4;
  const auto energy = [&](const Vector3d& n, double c) {
    const Immersion at = body.immersion({n, c});
    return kWanted * (n.dot(gravity) - c) - at.volume * (n.dot(at.centre_of_buoyancy) - c);
  };
  const Vector3d n = up_direction(trim, heel);
  const Immersion at = body.immersion({n, 0.05});
  const Vector3d point = rotation_centre(at, gravity);
  const Vector3d w = rotation_moment(at, point, kWanted, gravity);
  constexpr double kStep = 1e-3;  // the differences' error is its square
  for (FreeRotations free : {FreeRotations{true, false}, FreeRotations{false, true}}) {
    const NormalDirections directions = normal_directions(trim, heel, free);
    const auto turned = [&](double s) {
      const Vector3d up = free.trim ? up_direction(trim + s, heel) : up_direction(trim, heel + s);
      return energy(up, up.dot(point));
    };
    const double here = turned(0.0), ahead = turned(kStep), back = turned(-kStep);
    EXPECT_NEAR((ahead - back) / (2.0 * kStep), directions.columns.col(0).dot(w), 1e-6);
    EXPECT_NEAR((ahead - 2.0 * here + back) / (kStep * kStep),
                rotation_stiffness(directions, at, w)(0, 0), 1e-5);
  }
  const double sink = (energy(n, at.water.offset + kStep) - energy(n, at.water.offset - kStep));
  EXPECT_NEAR(sink / (2.0 * kStep), at.volume - kWanted, 1e-6);
  // Both ways at once: the mixed derivative, along the great circle through them.
  const NormalDirections both = normal_directions(trim, heel, {});
  EXPECT_NEAR((both.columns.transpose() * both.columns - Eigen::Matrix2d::Identity()).norm(), 0.0,
              1e-15);
  for (Eigen::Index k = 0; k < both.columns.cols(); ++k) {
    EXPECT_NEAR(both.columns.col(k).dot(n), 0.0, 1e-15);
  }
  const Vector3d way = (both.columns.col(0) + both.columns.col(1)) / std::sqrt(2.0);
  const auto along = [&](double s) {
    const Vector3d up = std::cos(s) * n + std::sin(s) * way;
    return energy(up, up.dot(point));
  };
  const Eigen::MatrixXd stiffness = rotation_stiffness(both, at, w);
  EXPECT_NEAR((along(kStep) - 2.0 * along(0.0) + along(-kStep)) / (kStep * kStep),
              0.5 * stiffness.sum(), 1e-5);
}

// A rest is a minimum of the energy at constant volume; a body turned with its load rests turned.
TEST(Equilibrium, OfRandomBodies) {
  std::mt19937 random(43);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 12; ++trial) {
    mesh::MeshArrays mesh = trial % 2 ? testing::cube() : testing::prism(5);
    testing::randomise(mesh, random, 0.2, 0.0, 0.2);
    for (auto& p : mesh.points) p.x() *= 4.0;
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const HullBody body(surface, false);
    const double whole = greatest_volume(body, Vector3d::UnitZ());
    const LoadCase load{whole * (0.5 + 0.4 * unit(random)),
                        {0.3 * unit(random), 0.1 * unit(random), 0.3 * unit(random)},
                        1.0};
    const Equilibrium e = equilibrium(body, load);
    ASSERT_EQ(e.status, EquilibriumStatus::kStable) << "trial " << trial << ": " << e.message;
    const auto energy = [&](const Vector3d& up) {
      int count = 0;
      const double c = offset_of_volume(body, up, load.mass_t, whole, 1e-12, count);
      return up.dot(load.centre_of_gravity - body.immersion({up, c}).centre_of_buoyancy);
    };
    const Vector3d n = e.immersion.water.normal;
    const NormalDirections directions = normal_directions(e.position.trim, e.position.heel, {});
    for (double s : {-0.01, 0.01}) {
      for (int k : {0, 1}) {
        EXPECT_GT(energy((n + s * directions.columns.col(k)).normalized()), energy(n))
            << "trial " << trial;
      }
    }
    // Turned about x by an angle, which then is missing in the heel.
    const double angle = 0.3;
    const Eigen::AngleAxisd turn(angle, Vector3d::UnitX());
    mesh::MeshArrays turned = mesh;
    for (auto& p : turned.points) p = turn * p;
    LoadCase turned_load = load;
    turned_load.centre_of_gravity = turn * load.centre_of_gravity;
    const surface::LimitSurface turned_surface{mesh::ControlMesh(turned)};
    EquilibriumOptions options;
    options.start.heel = -angle;
    const Equilibrium t = equilibrium(HullBody(turned_surface, false), turned_load, options);
    ASSERT_EQ(t.status, EquilibriumStatus::kStable) << t.message;
    EXPECT_NEAR(std::remainder(t.position.heel + angle - e.position.heel, 2.0 * std::numbers::pi),
                0.0, 1e-8);
    EXPECT_NEAR(t.position.trim, e.position.trim, 1e-8);
  }
}

// Several loads at once, each as if alone, whatever the numbering of the mesh.
TEST(Equilibrium, DoesNotDependOnNumberingOrCompany) {
  const testing::Polygon section = testing::round_section(7, 3.0, 2.0, 2.0, 0.2);
  const mesh::MeshArrays mesh = testing::barge(section, 15.0);
  mesh::MeshArrays renumbered = mesh;
  const int n = static_cast<int>(mesh.points.size());
  std::vector<int> place(n);
  for (int i = 0; i < n; ++i) place[i] = (5 * i + 3) % n;
  for (int i = 0; i < n; ++i) renumbered.points[place[i]] = mesh.points[i];
  for (int& v : renumbered.face_vertices) v = place[v];
  for (auto& [a, b] : renumbered.creases) {
    a = place[a];
    b = place[b];
  }
  const surface::LimitSurface a{mesh::ControlMesh(mesh)}, b{mesh::ControlMesh(renumbered)};
  const std::vector<LoadCase> loads{{60.0, {7.0, 0.1, 1.5}, 1.0}, {120.0, {8.0, -0.2, 1.2}, 1.0}};
  const HullBody body_a(a, false), body_b(b, false);
  const std::vector<Equilibrium> results = equilibria(body_a, loads);
  ASSERT_EQ(results.size(), loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Equilibrium other = equilibrium(body_b, loads[i]);
    EXPECT_NEAR(results[i].position.draft, other.position.draft, 1e-9);
    EXPECT_NEAR(results[i].position.trim, other.position.trim, 1e-10);
    EXPECT_NEAR(results[i].position.heel, other.position.heel, 1e-9);
  }
  EXPECT_TRUE(equilibria(body_a, {}).empty());
}

}  // namespace
}  // namespace hull::analysis

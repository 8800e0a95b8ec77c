// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "analysis/hydrostatics/hydrostatics.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

TEST(UprightHydrostatics, OfABox) {
  constexpr double kL = 40.0, kB = 8.0, kD = 5.0, kT = 2.7;
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(kL, kB, kD))};
  const Hydrostatics h = upright_hydrostatics(box, kT, false);
  constexpr double kRelative = 1e-13;
  EXPECT_NEAR(h.displaced_volume, kL * kB * kT, kRelative * kL * kB * kT);
  EXPECT_NEAR(h.lcb, 0.5 * kL, kRelative * kL);
  EXPECT_NEAR(h.tcb, 0.0, kRelative * kB);
  EXPECT_NEAR(h.kb, 0.5 * kT, kRelative * kT);
  EXPECT_NEAR(h.wetted_surface, kL * kB + 2.0 * kT * (kL + kB), kRelative * kL * kB);
  EXPECT_NEAR(h.waterplane_area, kL * kB, kRelative * kL * kB);
  EXPECT_NEAR(h.lcf, 0.5 * kL, kRelative * kL);
  EXPECT_NEAR(h.waterplane_inertia_transverse, kL * kB * kB * kB / 12.0, 1e-12 * kL * kB * kB * kB);
  EXPECT_NEAR(h.waterplane_inertia_longitudinal, kB * kL * kL * kL / 12.0,
              1e-12 * kB * kL * kL * kL);
  EXPECT_NEAR(h.km_transverse, 0.5 * kT + kB * kB / 12.0 / kT, 1e-12 * kB);
  EXPECT_NEAR(h.volume_from_breadths, h.displaced_volume, kRelative * h.displaced_volume);
}

// The cube control mesh ±1 encloses 2.62041903269898 (tests/reference/integrals.json).
TEST(UprightHydrostatics, OfTheSmoothCubeDrowned) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const Hydrostatics h = upright_hydrostatics(surface, 2.0, false);
  EXPECT_NEAR(h.displaced_volume, 2.62041903269898, 1e-14 * 3);
  EXPECT_NEAR(h.volume_from_breadths, h.displaced_volume, 1e-13);
  EXPECT_NEAR(h.waterplane_area, 0.0, 1e-14);
  EXPECT_NEAR(h.kb, 0.0, 1e-14);
}

// A smooth closed body cut by its middle plane: half of everything by symmetry.
TEST(UprightHydrostatics, OfTheSmoothCubeHalfImmersed) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const Hydrostatics half = upright_hydrostatics(surface, 0.0, false);
  const Hydrostatics whole = upright_hydrostatics(surface, 2.0, false);
  EXPECT_NEAR(2.0 * half.displaced_volume, whole.displaced_volume, 1e-13 * 2.7);
  EXPECT_NEAR(2.0 * half.wetted_surface, whole.wetted_surface, 1e-9);
  EXPECT_NEAR(half.waterplane_inertia_transverse, half.waterplane_inertia_longitudinal, 1e-13);
}

// dV/dT is the waterplane area; the step's error is its square times the second derivative.
TEST(UprightHydrostatics, VolumeGrowsByTheWaterplane) {
  constexpr unsigned kSeed = 92;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int trial = 0; trial < 20; ++trial) {
    mesh::MeshArrays arrays = testing::prism(3 + trial % 6);
    testing::randomise(arrays, random, 0.2, 0.0, 0.2);
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    constexpr double kStep = 1e-4;
    const double draft = -0.3 + 0.03 * trial;
    const Hydrostatics at = upright_hydrostatics(surface, draft, false);
    const double above = upright_hydrostatics(surface, draft + kStep, false).displaced_volume;
    const double below = upright_hydrostatics(surface, draft - kStep, false).displaced_volume;
    EXPECT_NEAR((above - below) / (2.0 * kStep), at.waterplane_area, 1e-6) << "trial " << trial;
  }
}

// The port half, doubled, gives what both halves give.
TEST(UprightHydrostatics, MirroredHalfEqualsTheWhole) {
  mesh::MeshArrays whole = testing::creased_box(20.0, 6.0, 4.0);
  mesh::MeshArrays half = testing::creased_box(20.0, 3.0, 4.0);
  for (auto& p : half.points) p.y() += 1.5;
  half.face_sizes.erase(half.face_sizes.begin() + 2);  // the face y = 0 is left open
  half.face_vertices.erase(half.face_vertices.begin() + 8, half.face_vertices.begin() + 12);
  const Hydrostatics a =
      upright_hydrostatics(surface::LimitSurface{mesh::ControlMesh(whole)}, 1.7, false);
  const Hydrostatics b =
      upright_hydrostatics(surface::LimitSurface{mesh::ControlMesh(half)}, 1.7, true);
  EXPECT_NEAR(a.displaced_volume, b.displaced_volume, 1e-11);
  EXPECT_NEAR(a.wetted_surface, b.wetted_surface, 1e-11);
  EXPECT_NEAR(a.waterplane_inertia_transverse, b.waterplane_inertia_transverse, 1e-10);
  EXPECT_NEAR(a.lcb, b.lcb, 1e-12);
  EXPECT_EQ(b.tcb, 0.0);
}

TEST(UprightHydrostatics, RefusesWhatMakesNoSense) {
  mesh::MeshArrays inward = testing::cube();
  for (std::size_t f = 0; f < 6; ++f) {
    std::reverse(inward.face_vertices.begin() + 4 * f, inward.face_vertices.begin() + 4 * f + 4);
  }
  const surface::LimitSurface surface{mesh::ControlMesh(inward)};
  EXPECT_THROW(upright_hydrostatics(surface, 0.0, false), std::invalid_argument);
  EXPECT_THROW(upright_hydrostatics(surface, NAN, false), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis

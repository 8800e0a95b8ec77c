// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_integrals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "conversion/exact/exact_conversion.h"
#include "conversion/sheets.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

TEST(PatchIntegrals, OfARectangle) {
  const SurfaceIntegrals flat = integrals_of(testing::rectangle(6.0, 4.0).patches[0]);
  EXPECT_NEAR(flat.area, 24.0, 1e-13);
  EXPECT_NEAR(flat.volume, 0.0, 1e-13);  // its plane contains the origin
}

// The graph of a quadratic function has a closed form of its volume: the cones from the origin and
// the column above the base differ by the walls'.
TEST(PatchIntegrals, OfAParaboloid) {
  const BSplinePatch patch = testing::sheet(1, 1, [](double s, double t) {
                               return Vector3d(s, t, 1.0 + s * t);
                             }).patches[0];
  // p · n = z - x z_x - y z_y = 1 + s t - 2 s t.
  EXPECT_NEAR(integrals_of(patch).volume, (1.0 - 0.25) / 3.0, 1e-12);
  // ∫∫ √(1 + s² + t²) over the unit square.
  EXPECT_NEAR(integrals_of(patch).area, 1.2807897, 1e-6);
}

TEST(PatchIntegrals, OfTheCubesSurfaceAreItsVolume) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  SurfaceIntegrals sum;
  for (const BSplinePatch& patch : exact_patches(surface, {.tolerance = 1e-8}).patches) {
    sum += integrals_of(patch);
  }
  EXPECT_NEAR(sum.volume, 2.62041903269898, 1e-7);
}

}  // namespace
}  // namespace hull::conversion

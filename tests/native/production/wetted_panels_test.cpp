// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/panels/wetted_panels.h"

#include <gtest/gtest.h>

#include <random>

#include "test_meshes.h"

namespace hull::production {
namespace {

surface::LimitSurface box_surface() {
  return surface::LimitSurface(mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0)));
}

// A box's faces are plane: panels that are cut exactly enclose its exact volume, whatever the
// water.
TEST(WettedPanelsTest, AreExactOfABoxInAnyWater) {
  const surface::LimitSurface surface = box_surface();
  const analysis::HullBody body(surface, false);
  std::mt19937 random(23);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    const analysis::FloatingPosition position{1.5 + share(random), 0.2 * share(random),
                                              0.8 * share(random), 5.0};
    const PanelMesh mesh = wetted_panels(body, position, {0.8, 0.6}, 5.0);
    const Vector3d volumes = mesh.volumes();
    for (double volume : volumes) {
      EXPECT_NEAR(volume, mesh.displaced_volume, 1e-12 * mesh.displaced_volume) << "seed 23, " << i;
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
      if (mesh.at_water[p]) {
        EXPECT_EQ(mesh.points[p].z(), 0.0);
      } else {
        EXPECT_LT(mesh.points[p].z(), 0.0);
      }
    }
  }
}

TEST(WettedPanelsTest, OfASubmergedBoxAreAllOfIt) {
  const surface::LimitSurface surface = box_surface();
  const analysis::HullBody body(surface, false);
  const PanelMesh mesh = wetted_panels(body, {7.0, 0.0, 0.0, 0.0}, {1.0, 1.0});
  EXPECT_NEAR(mesh.area(), 2.0 * (10.0 * 4.0 + 10.0 * 3.0 + 4.0 * 3.0), 1e-10);
  EXPECT_NEAR(mesh.volumes().y(), 120.0, 1e-10);
}

TEST(WettedPanelsTest, AreNoSmallerThanCellsWhereTheSizeIsLarge) {
  const surface::LimitSurface surface = box_surface();
  const analysis::HullBody body(surface, false);
  // The lower half of a box in cells of a quarter of its faces: 4 below and 2 of each side.
  EXPECT_EQ(wetted_panels(body, {1.5, 0.0, 0.0, 0.0}, {100.0, 1.0}).panels.size(), 12u);
}

TEST(WettedPanelsTest, RefusesWhatIsNoSizeAndAHullOutOfTheWater) {
  const surface::LimitSurface surface = box_surface();
  const analysis::HullBody body(surface, false);
  EXPECT_THROW(wetted_panels(body, {1.5}, {0.0}), std::invalid_argument);
  EXPECT_THROW(wetted_panels(body, {1.5}, {1.0, 1.5}), std::invalid_argument);
  EXPECT_THROW(wetted_panels(body, {-1.0}, {1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::production

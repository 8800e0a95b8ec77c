// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/border_plate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace hull::network {
namespace {

// With exact normals along its border a plate is the quadratic surface, whatever the border.
TEST(BorderPlate, ReproducesQuadraticHeights) {
  const auto height = [](double x, double y) { return 1 + x - y + 0.3 * x * x - 0.2 * x * y; };
  std::vector<PlateSample> border;
  for (int i = 0; i < 20; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 20, r = 1.0 + 0.2 * std::cos(3.0 * a);
    const double x = r * std::cos(a), y = r * std::sin(a);
    const double by_x = 1 + 0.6 * x - 0.2 * y, by_y = -1 - 0.2 * x;
    const double along_x = -std::sin(a), along_y = std::cos(a);
    border.push_back({{x, y, height(x, y)},
                      {along_x, along_y, by_x * along_x + by_y * along_y},
                      Vector3d(-by_x, -by_y, 1.0).normalized(),
                      true});
  }
  const auto plate = BorderPlate::within(border, true);
  ASSERT_TRUE(plate);
  for (const Vector2d& at : {Vector2d(0, 0), Vector2d(0.3, 0.1), Vector2d(-0.2, 0.4)}) {
    // Quadratic over one plane is not over another one: told where the mean plane is the same.
    const PatchPoint point = plate->at(at);
    EXPECT_NEAR(point.point.z(), height(point.point.x(), point.point.y()), 2e-2);
  }
  std::vector<PlateSample> upright = border;
  upright[3].normal = Vector3d(1, 0, 0);
  EXPECT_FALSE(BorderPlate::within(upright, true));
}

}  // namespace
}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/tangent_planes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace hull::network {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Around a place on a chine of 30°: along it, and across; one way along is turned out of the plane.
NodeStar chine_star(double turned, int chine, int across) {
  const double down = 30.0 * kDegree;
  return {{{std::cos(turned), 0.0, std::sin(turned)},
           {0.0, std::cos(down), -std::sin(down)},
           {-1.0, 0.0, 0.0},
           {0.0, -1.0, 0.0}},
          {chine, across, chine, across},
          std::vector<bool>(4, false),
          std::vector<bool>(4, false),
          Vector3d::UnitZ()};
}

TEST(TangentPlanes, CreasesAreThoseOfOneCurveWhateverTheNumbers) {
  for (double degrees : {0.0, 1e-6, 0.1, 1.5}) {
    for (const auto& [chine, across] : {std::pair{0, 1}, std::pair{1, 0}}) {
      const TangentPlanes planes =
          tangent_planes(chine_star(degrees * kDegree, chine, across), 2.0 * kDegree);
      EXPECT_TRUE(planes.has_planes);
      EXPECT_EQ(planes.is_crease, (std::vector{true, false, true, false})) << degrees;
    }
  }
}

TEST(TangentPlanes, TwoCurvesAreCreasesWhereNeitherAloneWillDo) {
  // Four planes, as around the tip of a pyramid.
  NodeStar star = chine_star(0.0, 0, 1);
  for (Vector3d& direction : star.directions) {
    direction.z() = -0.5;
    direction.normalize();
  }
  EXPECT_EQ(tangent_planes(star, 2.0 * kDegree).is_crease, std::vector<bool>(4, true));
}

}  // namespace
}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/network_patches.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <numbers>

#include "network_curves.h"
#include "patch_measures.h"

namespace hull::network {
namespace {

using hull::testing::chine;
using hull::testing::curve_along;
using hull::testing::ellipsoid;
using hull::testing::furthest_off;
using hull::testing::kDegree;
using hull::testing::net_on;
using hull::testing::network_of;
using hull::testing::patches_of;
using hull::testing::seam_angles;
using hull::testing::SeamAngles;
using hull::testing::torus;

TEST(NetworkPatches, OfATorusAndAnEllipsoidAreSmooth) {
  // Tolerances of curves such that spans decide.
  const std::pair<Vector3d (*)(double, double), int> surfaces[] = {{torus, 4}, {ellipsoid, 8}};
  for (const auto& [surface, least] : surfaces) {
    const CurveNetwork network = network_of(net_on(surface, 5, 4, 3));
    double before = 0.0;
    for (int spans : {least, 2 * least, 4 * least}) {
      const NetworkPatches made = patches_of(network, spans, surface == torus ? 1e-7 : 1e-5);
      const SeamAngles angles = seam_angles(network, made, spans);
      std::cout << spans << " spans: " << angles.at_knots << " deg at constraints, "
                << angles.anywhere << " deg anywhere\n";
      EXPECT_LT(angles.at_knots, 1e-6);
      EXPECT_LT(angles.anywhere, 0.05);
      if (before > 0.0) {
        EXPECT_LT(angles.anywhere, 0.5 * before);
      }
      before = angles.anywhere;
    }
  }
}

TEST(NetworkPatches, ComeNearerToASurfaceWithMoreCurves) {
  const auto off = [](const Vector3d& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 3.0;
  };
  double before = 0.0;
  for (int count : {2, 4, 8}) {
    const double worst = furthest_off(patches_of(network_of(net_on(torus, count, count, 3))), off);
    std::cout << count << " curves each way: torus " << worst << " m of 3\n";
    if (before > 0.0) {
      EXPECT_LT(worst, before / 8.0);
    }
    before = worst;
  }
}

TEST(NetworkPatches, PlanesAtAnAngleKeepIt) {
  const double angle = 30.0 * kDegree;
  const CurveNetwork network = network_of(chine(angle));
  const NetworkPatches made = patches_of(network);
  const SeamAngles angles = seam_angles(network, made, 4, 30.0);
  EXPECT_LT(angles.of_creases, 1e-6);
  EXPECT_LT(angles.anywhere, 1e-6);
  EXPECT_LT(furthest_off(made,
                         [&](const Vector3d& p) {
                           const double over = std::max(0.0, p.y() - 5.0);
                           return p.z() + over * std::tan(angle);
                         }),
            1e-12);
}

std::vector<NetworkCurve> octant() {
  std::vector<NetworkCurve> curves;
  for (int i = 0; i < 3; ++i) {
    NetworkCurve arc;
    arc.definition.name = "A" + std::to_string(i);
    arc.definition.kind = CurveDefinition::Kind::kArc;
    const Vector3d from = Vector3d::Unit(i), to = Vector3d::Unit((i + 1) % 3);
    arc.definition.points = {from, std::sqrt(0.5) * (from + to), to};
    curves.push_back(arc);
  }
  return curves;
}

TEST(NetworkPatches, OfASpheresOctantAreThreeAroundItsMiddle) {
  const CurveNetwork network = network_of(octant());
  for (int spans : {4, 8}) {
    const NetworkPatches made = patches_of(network, spans);
    EXPECT_EQ(made.set.patches.size(), 3u);
    const double off = furthest_off(made, [](const Vector3d& p) { return p.norm() - 1.0; });
    const SeamAngles angles = seam_angles(network, made, spans);
    std::cout << spans << " spans: octant off by " << off << " of its radius, seams "
              << angles.at_knots << ", " << angles.anywhere << " deg\n";
    EXPECT_LT(off, 5e-3);
    EXPECT_LT(angles.at_knots, 1e-6);
    EXPECT_LT(angles.anywhere, 0.5);
  }
}

TEST(NetworkPatches, RegionsOfManySidesAreFound) {
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * x * y + 0.1 * y * y; };
  for (int count : {3, 5, 6, 8, 10}) {
    std::vector<NetworkCurve> curves;
    for (int i = 0; i < count; ++i) {
      const auto corner = [count](int k) {
        const double a = 2.0 * std::numbers::pi * k / count;
        return Vector3d(std::cos(a), std::sin(a), 0.0);
      };
      curves.push_back(curve_along(
          "C" + std::to_string(i),
          [&](double t) {
            Vector3d p = (1.0 - t) * corner(i) + t * corner(i + 1);
            p.z() = height(p.x(), p.y());
            return p;
          },
          17));
    }
    const CurveNetwork network = network_of(curves);
    const NetworkPatches made = patches_of(network);
    EXPECT_EQ(std::ssize(made.set.patches), count);
    const double off =
        furthest_off(made, [&](const Vector3d& p) { return p.z() - height(p.x(), p.y()); });
    const SeamAngles angles = seam_angles(network, made, 4);
    std::cout << count << " sides: off by " << off << ", seams " << angles.at_knots << ", "
              << angles.anywhere << " deg\n";
    EXPECT_LT(off, 8e-3);
    EXPECT_LT(angles.at_knots, 1e-6);
    EXPECT_LT(angles.anywhere, 0.5);
  }
}

TEST(NetworkPatches, TeesAndDanglingEndsAreNoObstacle) {
  auto curves = net_on(torus, 2, 2, 3);
  curves.push_back(curve_along("T", [](double t) { return torus(0.75, 0.5 * t); }));
  curves.push_back(curve_along("D", [](double t) { return torus(0.3 * t, 0.25); }));
  const CurveNetwork network = network_of(curves);
  std::vector<NetworkProblem::Kind> kinds = hull::testing::kinds_of(network);
  EXPECT_EQ(std::ranges::count(kinds, NetworkProblem::Kind::kTee), 1);
  EXPECT_EQ(std::ranges::count(kinds, NetworkProblem::Kind::kDanglingEnd), 1);
  const NetworkPatches made = patches_of(network);
  EXPECT_EQ(made.set.patches.size(), 5u);
  // The sides with the tee in them, and where the dangling curve began, are two edges.
  int divided = 0;
  for (const auto& sides : made.set.sides) {
    for (const auto& side : sides) divided += side.size() > 1 ? 1 : 0;
  }
  EXPECT_EQ(divided, 2);
}

TEST(NetworkPatches, WithACurveMovedAreThoseMadeAnew) {
  auto curves = net_on(torus, 5, 4, 1);
  CurveNetwork network = network_of(curves);
  NetworkPatches made = network_patches(network, {});
  for (std::size_t i = 1; i < curves[2].definition.points.size(); i += 2) {
    curves[2].definition.points[i] *= 1.002;
  }
  network = network.with_curve(2, curves[2]);
  const NetworkPatches changed = network_patches(network, {}, &made);
  const NetworkPatches anew = network_patches(network_of(curves), {});
  ASSERT_EQ(changed.set.patches.size(), anew.set.patches.size());
  int same = 0;
  for (std::size_t p = 0; p < anew.set.patches.size(); ++p) {
    EXPECT_EQ(changed.set.patches[p].control_points, anew.set.patches[p].control_points);
    same += anew.set.patches[p].control_points == made.set.patches[p].control_points ? 1 : 0;
  }
  EXPECT_GE(same, 2);
}

TEST(NetworkPatches, RefuseWhatIsNoOption) {
  const CurveNetwork network = network_of(hull::testing::square());
  EXPECT_THROW(network_patches(network, {0, 0.0}), std::invalid_argument);
  EXPECT_THROW(network_patches(network, {65, 0.0}), std::invalid_argument);
  EXPECT_THROW(network_patches(network, {4, -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::network

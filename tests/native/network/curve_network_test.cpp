// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model/curve_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

#include "network_curves.h"
#include "random_values.h"

namespace hull::network {
namespace {

using hull::testing::chine;
using hull::testing::curve_along;
using hull::testing::kinds_of;
using hull::testing::kTol;
using hull::testing::line_between;
using hull::testing::net_on;
using hull::testing::network_of;
using hull::testing::told;
using hull::testing::torus;

// Length 100, breadth 10, draft 6.25 m: the port quarter forward.
Vector3d wigley(double u, double v) {
  const double x = 50.0 * u, z = -6.25 * (1.0 - v);
  return {x, 5.0 * (1.0 - u * u) * (1.0 - (1.0 - v) * (1.0 - v)), z};
}

using Key = std::vector<long>;
Key key_of(const Vector3d& place) {
  Key key;
  for (int i = 0; i < 3; ++i) key.push_back(std::lround(place[i] * 1e6));
  return key;
}

TEST(CurveNetwork, OfANetHasItsNodesEdgesAndRegions) {
  const CurveNetwork network = network_of(net_on(torus, 5, 4, 1));
  EXPECT_EQ(told(network), "");
  EXPECT_EQ(network.frame().joined.nodes.size(), 30u);
  EXPECT_EQ(network.frame().joined.edges.size(), 4u * 6 + 5u * 5);
  EXPECT_EQ(network.regions().size(), 20u);
  EXPECT_EQ(network.frame().faces.border.size(), 18u);
  for (const auto& sides : network.regions()) EXPECT_EQ(sides.size(), 4u);
  for (const Vector3d& node : network.frame().joined.nodes) {
    // Exactly on the torus: curves have points there.
    const double ring = std::hypot(node.x(), node.y()) - 10.0;
    EXPECT_NEAR(std::hypot(ring, node.z()), 3.0, 1e-12);
  }
  int border = 0, smooth = 0;
  for (const CurveRole& role : network.roles()) {
    EXPECT_EQ(role.crease, 0);
    border += role.border;
    smooth += role.smooth;
  }
  EXPECT_EQ(border, 18);
  EXPECT_EQ(smooth, 31);
}

TEST(CurveNetwork, NormalsPointOutwards) {
  for (const auto& surface : {torus, wigley}) {
    const CurveNetwork network = network_of(net_on(surface, 5, 4, 1));
    for (int region = 0; region < 20; ++region) {
      const PatchPoint middle = network.patch(region).at({0.5, 0.5});
      EXPECT_GT(middle.normal().y(), 0.0) << region;
    }
  }
}

TEST(CurveNetwork, IsTheSameWhateverTheOrderAndTheSenseOfCurves) {
  std::mt19937 random(41);
  const auto curves = net_on(torus, 4, 3, 1);
  std::map<Key, Key> middles;
  for (int trial = 0; trial < 8; ++trial) {
    auto mixed = curves;
    if (trial > 0) {
      std::ranges::shuffle(mixed, random);
      for (NetworkCurve& curve : mixed) {
        if (random() % 2 == 0) std::ranges::reverse(curve.definition.points);
      }
    }
    const CurveNetwork network = network_of(mixed);
    ASSERT_EQ(told(network), "");
    ASSERT_EQ(network.regions().size(), 12u);
    std::map<Key, Key> now;
    for (int region = 0; region < 12; ++region) {
      const PatchPoint middle = network.patch(region).at({0.5, 0.5});
      now[key_of(middle.point)] = key_of(middle.normal());
    }
    if (trial == 0) {
      middles = now;
    } else {
      EXPECT_EQ(now, middles);
    }
  }
}

// The angle between the two patches at an edge.
double worst_seam(const CurveNetwork& network, bool of_creases) {
  std::map<int, std::vector<std::pair<int, std::size_t>>> users;
  std::vector<TransfinitePatch> patches;
  for (int r = 0; r < static_cast<int>(network.regions().size()); ++r) {
    patches.push_back(network.patch(r));
    const auto& sides = network.regions()[static_cast<std::size_t>(r)];
    for (std::size_t s = 0; s < sides.size(); ++s) {
      if (sides[s].size() == 1) users[sides[s].front().edge].emplace_back(r, s);
    }
  }
  double worst = 0.0;
  for (const auto& [edge, both] : users) {
    const bool is_crease = network.frame().normals.is_crease[static_cast<std::size_t>(edge)];
    if (both.size() != 2 || is_crease != of_creases) continue;
    for (int i = 1; i < 20; ++i) {
      std::vector<PatchPoint> points;
      for (const auto& [r, s] : both) {
        const auto& patch = patches[static_cast<std::size_t>(r)];
        const auto& domain = patch.domain();
        // Shares of one edge, from one end for the one and from the other for the other.
        const double u = points.empty() ? i / 20.0 : 1.0 - i / 20.0;
        points.push_back(patch.at((1.0 - u) * domain[s] + u * domain[(s + 1) % domain.size()]));
      }
      EXPECT_LT((points[0].point - points[1].point).norm(), 1e-12);
      const Vector3d a = points[0].normal(), b = points[1].normal();
      worst = std::max(worst, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return worst;
}

TEST(CurveNetwork, NeighboursHaveOneTangentPlaneAlongTheirEdge) {
  EXPECT_LT(worst_seam(network_of(net_on(torus, 5, 4, 3)), false), 1e-9);
  EXPECT_LT(worst_seam(network_of(net_on(wigley, 4, 3, 1)), false), 1e-9);
}

double worst_off(const CurveNetwork& network, const std::function<double(const Vector3d&)>& off) {
  double worst = 0.0;
  for (int r = 0; r < static_cast<int>(network.regions().size()); ++r) {
    const TransfinitePatch patch = network.patch(r);
    for (int i = 0; i <= 8; ++i) {
      for (int k = 0; k <= 8; ++k) {
        worst = std::max(worst, std::abs(off(patch.at({i / 8.0, k / 8.0}).point)));
      }
    }
  }
  return worst;
}

TEST(CurveNetwork, PatchesComeNearerWithMoreCurves) {
  const auto off_torus = [](const Vector3d& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 3.0;
  };
  const auto off_wigley = [](const Vector3d& p) {
    return p.y() - 5.0 * (1.0 - p.x() * p.x() / 2500.0) * (1.0 - p.z() * p.z() / 39.0625);
  };
  double before = 0.0;
  for (int count : {2, 4, 8}) {
    const double off = worst_off(network_of(net_on(torus, count, count, 3)), off_torus);
    const double off_hull = worst_off(network_of(net_on(wigley, count, count, 3)), off_wigley);
    std::cout << count << " curves each way: torus " << off << " m of 3, Wigley " << off_hull
              << " m of 5\n";
    if (before > 0.0) {
      EXPECT_LT(off, before / 6.0);
    }
    before = off;
  }
}

TEST(CurveNetwork, AKnuckleIsFoundAndKeepsItsAngle) {
  for (double degrees : {10.0, 30.0, 80.0, 120.0, -30.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    for (bool is_said : {false, true}) {
      auto curves = chine(angle);
      if (is_said) curves[1].kind = NetworkCurve::Kind::kKnuckle;
      const CurveNetwork network = network_of(curves);
      ASSERT_EQ(told(network), "") << degrees;
      ASSERT_EQ(network.regions().size(), 6u);
      const auto roles = network.roles();
      EXPECT_EQ(roles[1].crease, 3);
      EXPECT_EQ(roles[4].smooth, 2);
      EXPECT_NEAR(worst_seam(network, true), std::abs(angle), 1e-12);
      EXPECT_LT(worst_seam(network, false), 1e-12);
    }
  }
}

TEST(CurveNetwork, RegionsHaveTwoToTenSides) {
  for (int count : {2, 3, 5, 8, 10, 11}) {
    std::vector<NetworkCurve> curves;
    const auto at = [count](int i) {
      const double a = 2.0 * std::numbers::pi * i / count;
      return Vector3d(3 * std::cos(a), 3 * std::sin(a), 0);
    };
    for (int i = 0; i < count; ++i) {
      NetworkCurve arc;
      arc.definition.name = "A" + std::to_string(i);
      arc.definition.kind = CurveDefinition::Kind::kArc;
      // Two arcs meet at 60°, more at their polygon's angles.
      const double bulge = count == 2 ? std::numbers::pi / 6 : 0.02;
      const Vector3d a = at(i), b = at(i + 1);
      const Vector3d middle = 0.5 * (a + b), out = Vector3d(b.y() - a.y(), a.x() - b.x(), 0);
      arc.definition.points = {a, middle + 0.5 * std::tan(0.5 * bulge) * out, b};
      curves.push_back(arc);
    }
    const CurveNetwork network = network_of(curves);
    ASSERT_EQ(network.regions().size(), 1u) << count << told(network);
    EXPECT_EQ(network.regions()[0].size(), static_cast<std::size_t>(count));
    if (count > 10) {
      EXPECT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kManySides});
      EXPECT_THROW(network.patch(0), std::invalid_argument);
    } else {
      EXPECT_EQ(told(network), "");
      const TransfinitePatch patch = network.patch(0);
      EXPECT_NEAR(patch.at(patch.domain()[0] * 0.4).point.z(), 0.0, 1e-14);
    }
  }
}

TEST(CurveNetwork, TheTolerancesSizeDoesNotShowInExactNetworks) {
  for (double tolerance : {1e-6, 1e-4, 1e-2}) {
    const CurveNetwork network = network_of(net_on(torus, 3, 3, 1), tolerance);
    EXPECT_EQ(told(network), "");
    EXPECT_EQ(network.regions().size(), 9u);
  }
}

TEST(CurveNetwork, WithAnotherCurveItIsWhatItIsAnew) {
  std::mt19937 random(43);
  auto curves = net_on(torus, 4, 3, 1);
  curves[2].definition.start = {EndCondition::Kind::kSlaveTangent, Vector3d::Zero(), 6};
  CurveNetwork network = network_of(curves);
  for (int trial = 0; trial < 20; ++trial) {
    const auto number = static_cast<std::size_t>(random() % curves.size());
    // Points between crossings move, crossings stay; now and then they do not.
    auto& points = curves[number].definition.points;
    for (std::size_t i = 1; i < points.size(); i += 2) {
      points[i] += 0.1 * hull::testing::random_vector(random);
    }
    if (trial % 5 == 4) points[2] += 3.0 * kTol * hull::testing::random_vector(random).normalized();
    network = network.with_curve(static_cast<int>(number), curves[number]);
    const CurveNetwork anew = network_of(curves);
    EXPECT_EQ(told(network), told(anew));
    EXPECT_EQ(network.frame().joined.nodes, anew.frame().joined.nodes);
    EXPECT_EQ(network.regions().size(), anew.regions().size());
  }
  EXPECT_THROW(network.with_curve(9, curves[0]), std::invalid_argument);
  // Two that cross, at once.
  for (std::size_t number : {1u, 5u}) {
    auto& points = curves[number].definition.points;
    points[1] += 0.1 * hull::testing::random_vector(random);
  }
  EXPECT_EQ(network.with_curves(curves).frame().joined.nodes,
            network_of(curves).frame().joined.nodes);
  curves.pop_back();
  EXPECT_THROW(network.with_curves(curves), std::invalid_argument);
}

TEST(CurveNetwork, OnASpheresOctantHasItsNormalsOnTheBorder) {
  std::vector<NetworkCurve> curves;
  const double half = std::sqrt(0.5);
  for (int i = 0; i < 3; ++i) {
    NetworkCurve arc;
    arc.definition.name = "A" + std::to_string(i);
    arc.definition.kind = CurveDefinition::Kind::kArc;
    const Vector3d from = Vector3d::Unit(i), to = Vector3d::Unit((i + 1) % 3);
    arc.definition.points = {from, half * (from + to), to};
    curves.push_back(arc);
  }
  const CurveNetwork network = network_of(curves);
  EXPECT_EQ(told(network), "");
  ASSERT_EQ(network.regions().size(), 1u);
  const TransfinitePatch patch = network.patch(0);
  for (std::size_t side = 0; side < 3; ++side) {
    for (int i = 0; i <= 20; ++i) {
      const Vector2d at =
          (1.0 - i / 20.0) * patch.domain()[side] + i / 20.0 * patch.domain()[(side + 1) % 3];
      const PatchPoint point = patch.at(at);
      EXPECT_NEAR(point.point.norm(), 1.0, 1e-14);
      // The centre is not outside, wherever the octant is: the sense is that of the upper end.
      const double sense = point.normal().dot(point.point) > 0.0 ? 1.0 : -1.0;
      if (i == 0 || i == 20) continue;
      EXPECT_LT((sense * point.normal() - point.point).norm(), 1e-9);
    }
  }
  // By hand: ribbons are √2 long all the way, so that each corner's patch has h, h and 2h - 1 in
  // the middle, h = √½. It bulges by 5.6 % of the radius.
  EXPECT_NEAR(patch.at({0, 0}).point.norm(), (2.0 * std::sqrt(2.0) - 1.0) / std::sqrt(3.0), 1e-14);
}

TEST(CurveNetwork, ErrorsWithinTheToleranceLeaveItsTopology) {
  std::mt19937 random(42);
  for (int trial = 0; trial < 20; ++trial) {
    auto curves = net_on(torus, 4, 3, 1);
    for (NetworkCurve& curve : curves) {
      // As a whole: two curves are off one another by 0.9 of it at most.
      const Vector3d shift = 0.45 * kTol * hull::testing::random_vector(random).normalized();
      for (Vector3d& point : curve.definition.points) point += shift;
    }
    const CurveNetwork network = network_of(curves);
    EXPECT_EQ(told(network), "");
    EXPECT_EQ(network.frame().joined.nodes.size(), 20u);
    ASSERT_EQ(network.regions().size(), 12u);
    EXPECT_LT(worst_seam(network, false), 1e-2);
    for (const auto& sides : network.regions()) EXPECT_EQ(sides.size(), 4u);
  }
}

}  // namespace
}  // namespace hull::network

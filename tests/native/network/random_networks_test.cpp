// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "network/model/curve_network.h"
#include "network_curves.h"
#include "random_values.h"
#include "trials.h"

namespace hull::network {
namespace {

using hull::testing::kTol;
using hull::testing::line_between;
using hull::testing::network_of;
using hull::testing::square;
using hull::testing::told;
using hull::testing::uniform;

// By shares of the way around the square of 10 m.
Vector3d on_border(double share) {
  const double way = 40.0 * share, part = std::fmod(way, 10.0);
  if (way < 10.0) return {part, 0, 0};
  if (way < 20.0) return {10, part, 0};
  if (way < 30.0) return {10 - part, 10, 0};
  return {0, 10 - part, 0};
}

double area_of(const CurveNetwork& network, std::size_t region) {
  const auto& joined = network.frame().joined;
  double area = 0.0;
  for (const RegionEdge& side : network.frame().faces.loops[region]) {
    const CurveEdge& edge = joined.edges[static_cast<std::size_t>(side.edge)];
    const Vector3d& a = joined.nodes[static_cast<std::size_t>(side.is_along ? edge.from : edge.to)];
    const Vector3d& b = joined.nodes[static_cast<std::size_t>(side.is_along ? edge.to : edge.from)];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

TEST(RandomNetworks, OfLinesInASquareHaveTheRegionsOfTheFormula) {
  std::mt19937 random(44);
  int counted = 0;
  for (int trial = 0; trial < testing::trials(200); ++trial) {
    auto curves = square();
    std::vector<std::array<double, 2>> chords;
    const int count = 1 + static_cast<int>(random() % 12);
    for (int i = 0; i < count; ++i) {
      const double from = uniform(random, 0.0, 1.0);
      const double to = std::fmod(from + uniform(random, 0.3, 0.7), 1.0);
      chords.push_back({std::min(from, to), std::max(from, to)});
      curves.push_back(line_between("L" + std::to_string(i), on_border(from), on_border(to)));
    }
    int crossings = 0;
    for (std::size_t i = 0; i < chords.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const auto is_within = [&](double share) {
          return share > chords[i][0] && share < chords[i][1];
        };
        crossings += is_within(chords[k][0]) != is_within(chords[k][1]) ? 1 : 0;
      }
    }
    const CurveNetwork network = network_of(curves, 1e-8);
    if (!network.problems().empty()) continue;  // nodes too near one another: named
    ++counted;
    ASSERT_EQ(static_cast<int>(network.regions().size()), count + crossings + 1) << trial;
    double whole = 0.0;
    for (std::size_t region = 0; region < network.regions().size(); ++region) {
      const double area = area_of(network, region);
      // All around the same way; which, a network in one plane leaves open.
      EXPECT_GT(area * area_of(network, 0), 0.0);
      whole += std::abs(area);
    }
    EXPECT_NEAR(whole, 100.0, 1e-12);
  }
  EXPECT_GT(counted, testing::trials(100));
}

// Whatever comes, there is a network with patches, or a word about what it lacks.
TEST(RandomNetworks, OfAnyCurvesAreMadeOrNamed) {
  std::mt19937 random(45);
  int regions = 0, problems = 0;
  for (int trial = 0; trial < testing::trials(300); ++trial) {
    std::vector<NetworkCurve> curves;
    const bool is_flat = trial % 2 == 0;
    const int count = 1 + static_cast<int>(random() % 9);
    for (int i = 0; i < count; ++i) {
      NetworkCurve curve;
      curve.definition.name = "C" + std::to_string(i);
      const int points = 2 + static_cast<int>(random() % 4);
      for (int k = 0; k < points; ++k) {
        // On a coarse lattice, so that points, ends and whole curves coincide.
        Vector3d place = (2.0 * testing::random_vector(random)).array().round();
        if (is_flat) place.z() = 0.0;
        auto& all = curve.definition.points;
        if (all.empty() || (all.back() - place).norm() > 0.5) all.push_back(place);
      }
      if (curve.definition.points.size() > 2 && random() % 2 == 0) curve.definition.knuckles = {1};
      curves.push_back(curve);
    }
    const CurveNetwork network = network_of(curves);
    for (const NetworkProblem& problem : network.problems()) {
      EXPECT_FALSE(problem.what.empty());
      ++problems;
    }
    for (int region = 0; region < static_cast<int>(network.regions().size()); ++region) {
      const std::size_t sides = network.regions()[static_cast<std::size_t>(region)].size();
      if (sides < 2 || sides > 10) {
        EXPECT_THROW(network.patch(region), std::invalid_argument);
        continue;
      }
      ++regions;
      const auto is_halt = [](const NetworkProblem& problem) {
        return problem.kind == NetworkProblem::Kind::kHalt;
      };
      if (std::ranges::any_of(network.problems(), is_halt)) continue;
      const TransfinitePatch patch = network.patch(region);
      for (const Vector2d& corner : patch.domain()) {
        EXPECT_TRUE(patch.at(corner).point.allFinite()) << trial << told(network);
        EXPECT_TRUE(patch.at(0.6 * corner + 0.4 * patch.domain()[0]).point.allFinite());
      }
    }
  }
  EXPECT_GT(regions, testing::trials(300));
  EXPECT_GT(problems, testing::trials(300));
}

// A curve that leaves a line and comes back to it without an angle; directions are one but for
// rounding.
NetworkCurve tangent_arch(const Vector3d& from, const Vector3d& to, const Vector3d& rise) {
  const Vector3d way = (to - from).normalized();
  NetworkCurve arch;
  arch.definition.name = "Arch";
  arch.definition.points = {from, 0.5 * (from + to) + rise, to};
  arch.definition.start = {EndCondition::Kind::kTangent, way, -1};
  arch.definition.end = {EndCondition::Kind::kTangent, way, -1};
  return arch;
}

TEST(RandomNetworks, ARegionWithoutAnAngleAtItsCornersIsNotBeyondTheBorder) {
  std::mt19937 random(53);
  for (int trial = 0; trial < hull::testing::trials(40); ++trial) {
    const Vector3d right = hull::testing::random_vector(random).normalized();
    const Vector3d up = right.cross(hull::testing::random_vector(random)).normalized();
    const std::vector<NetworkCurve> curves{
        line_between("L", 5.0 * up, 10.0 * right + 5.0 * up),
        tangent_arch(5.0 * up, 10.0 * right + 5.0 * up, 2.0 * up)};
    const CurveNetwork lens = network_of(curves);
    ASSERT_EQ(lens.regions().size(), 1u) << told(lens);
    const JoinedCurves& joined = lens.frame().joined;
    const NodeOrder order = node_order(joined, lens.frame().shapes);
    const bool is_arch_left = order.normals.front().dot(right.cross(up)) > 0.0;
    for (const RegionEdge& side : lens.frame().faces.loops.front()) {
      const bool is_line = joined.edges[static_cast<std::size_t>(side.edge)].curve == 0;
      EXPECT_EQ(side.is_along, is_line == is_arch_left) << trial;
    }
    for (const std::vector<double>& angles : order.angles) {
      EXPECT_NEAR(angles[0] + angles[1], 2.0 * std::numbers::pi, 1e-12);
    }
  }
}

}  // namespace
}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "network/model/curve_network.h"
#include "network_curves.h"

namespace hull::network {
namespace {

using hull::testing::curve_along;
using hull::testing::kinds_of;
using hull::testing::kTol;
using hull::testing::line_between;
using hull::testing::net_on;
using hull::testing::network_of;
using hull::testing::square;
using hull::testing::told;

TEST(NetworkProblems, CurvesThatMissOneAnotherByHalfTheToleranceAreJoined) {
  for (double gap : {0.0, 0.5 * kTol, 2.0 * kTol}) {
    auto curves = net_on([](double u, double v) { return Vector3d(10 * u, 10 * v, 0); }, 2, 2, 0);
    // The middle one of U, off all that it crosses.
    for (Vector3d& point : curves[1].definition.points) point.z() += gap;
    const CurveNetwork network = network_of(curves);
    if (gap <= kTol) {
      EXPECT_EQ(told(network), "");
      EXPECT_EQ(network.regions().size(), 4u);
      for (int r = 0; r < 4; ++r) EXPECT_NO_THROW(network.patch(r));
      continue;
    }
    ASSERT_EQ(network.problems().size(), 4u) << told(network);
    int gaps = 0;
    for (const NetworkProblem& problem : network.problems()) {
      if (problem.kind != NetworkProblem::Kind::kGap) continue;
      ++gaps;
      EXPECT_EQ(problem.curves[0], 1);
      ASSERT_EQ(problem.places.size(), 2u);
      EXPECT_NEAR((problem.places[0] - problem.places[1]).norm(), gap, 1e-12);
      EXPECT_NE(problem.what.find("2 mm, more than the tolerance of 1 mm"), std::string::npos);
    }
    EXPECT_EQ(gaps, 3);
    EXPECT_EQ(network.problems()[3].kind, NetworkProblem::Kind::kApart);
  }
}

TEST(NetworkProblems, ADanglingEndIsNamedAndLeftOut) {
  auto curves = square();
  curves.push_back(line_between("S", {4, -2, 0}, {4, 10, 0}));
  const CurveNetwork network = network_of(curves);
  ASSERT_EQ(network.problems().size(), 1u) << told(network);
  const NetworkProblem& problem = network.problems()[0];
  EXPECT_EQ(problem.kind, NetworkProblem::Kind::kDanglingEnd);
  EXPECT_LT((problem.places[0] - Vector3d(4, -2, 0)).norm(), 1e-12);
  EXPECT_LT((problem.places[1] - Vector3d(4, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(network.regions().size(), 2u);
  // One that ends within a region, over an edge between: all of it.
  curves.back() = line_between("S", {4, -2, 0}, {4, 7, 0});
  const CurveNetwork other = network_of(curves);
  EXPECT_EQ(other.problems().size(), 2u) << told(other);
  EXPECT_EQ(other.regions().size(), 1u);
}

TEST(NetworkProblems, AnOvershootWithinTheToleranceIsNone) {
  auto curves = square();
  curves.push_back(line_between("S", {4, -0.5 * kTol, 0}, {4, 10 + 0.5 * kTol, 0}));
  const CurveNetwork network = network_of(curves);
  EXPECT_EQ(told(network), "");
  EXPECT_EQ(network.regions().size(), 2u);
}

TEST(NetworkProblems, ATeeIsANote) {
  auto curves = square();
  curves.push_back(line_between("S", {4, 0, 0}, {4, 10, 0}));
  curves.push_back(line_between("W", {4, 5, 0}, {10, 5, 0}));
  const CurveNetwork network = network_of(curves);
  ASSERT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kTee}) << told(network);
  EXPECT_TRUE(network.problems()[0].is_note());
  EXPECT_LT((network.problems()[0].places[0] - Vector3d(4, 5, 0)).norm(), 1e-12);
  ASSERT_EQ(network.regions().size(), 3u);
  // Beyond the tee the region has four sides, one of two edges.
  std::size_t edges = 0;
  for (const auto& sides : network.regions()) {
    EXPECT_EQ(sides.size(), 4u);
    for (const RegionSide& side : sides) edges = std::max(edges, side.size());
  }
  EXPECT_EQ(edges, 2u);
  for (int region = 0; region < 3; ++region) {
    EXPECT_LT(std::abs(network.patch(region).at({0.3, 0.6}).point.z()), 1e-14);
  }
}

TEST(NetworkProblems, WhatIsTwiceThereOrOnOneAnotherIsNamed) {
  auto curves = square();
  curves.push_back(line_between("S", {10, 0, 0}, {0, 0, 0}));
  EXPECT_EQ(kinds_of(network_of(curves)), std::vector{NetworkProblem::Kind::kDuplicate});
  // A part of another one, and one of which another is a part: the longer one is joined.
  for (bool is_longer_first : {true, false}) {
    auto with_part = square();
    const auto at = is_longer_first ? with_part.end() : with_part.begin();
    with_part.insert(at, line_between("S", {7, 0, 0}, {2, 0, 0}));
    const CurveNetwork network = network_of(with_part);
    EXPECT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kOverlap}) << told(network);
    EXPECT_EQ(network.regions().size(), 1u);
  }
  curves.back() = line_between("S", {4, 0, 0}, {15, 0, 0});
  const auto kinds = kinds_of(network_of(curves));
  EXPECT_NE(std::ranges::find(kinds, NetworkProblem::Kind::kOverlap), kinds.end());
}

TEST(NetworkProblems, WhatIsApartIsNamed) {
  auto curves = square();
  for (NetworkCurve curve : square()) {
    for (Vector3d& point : curve.definition.points) point.x() += 50.0;
    curve.definition.name = "far " + curve.definition.name;
    curves.push_back(curve);
  }
  const CurveNetwork network = network_of(curves);
  ASSERT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kApart});
  EXPECT_EQ(network.problems()[0].curves.size(), 4u);
  EXPECT_EQ(network.regions().size(), 1u);
}

TEST(NetworkProblems, EachPointOffItsPlaneIsNamed) {
  auto curves = square();
  curves[0].definition.plane = CarrierPlane{{2, 0, 0}, 0.0};
  curves[0].definition.points[1].x() += 2e-3;
  curves[0].definition.points[2].x() -= 3e-3;
  const CurveNetwork network = network_of(curves);
  EXPECT_EQ(kinds_of(network), std::vector(2, NetworkProblem::Kind::kOffPlane));
  EXPECT_NE(told(network).find("Point 2 of curve U0"), std::string::npos);
  EXPECT_TRUE(network.regions().empty());
}

TEST(NetworkProblems, ACrossingAtASmallAngleBesideAKnuckleIsOneNode) {
  auto curves = square();
  // Two lines with a knuckle that is off the line it should be on, by less than the tolerance.
  NetworkCurve bent;
  bent.definition.name = "B";
  bent.definition.points = {{0, 4.8, 0}, {5, 5 + 0.4 * kTol, 0}, {10, 4.9, 0}};
  bent.definition.knuckles = {1};
  curves.push_back(line_between("A", {0, 5, 0}, {10, 5, 0}));
  curves.push_back(bent);
  const CurveNetwork network = network_of(curves);
  EXPECT_EQ(told(network), "");
  EXPECT_EQ(network.regions().size(), 4u);
}

TEST(NetworkProblems, TwoNodesThatAreNearlyOneAreNamed) {
  auto curves = square();
  curves.push_back(line_between("A", {4, 0, 0}, {4, 10, 0}));
  curves.push_back(line_between("B", {4 + 5 * kTol, 0, 0}, {6, 10, 0}));
  const CurveNetwork network = network_of(curves);
  const auto kinds = kinds_of(network);
  ASSERT_EQ(std::ranges::count(kinds, NetworkProblem::Kind::kShortEdge), 1) << told(network);
  EXPECT_NE(told(network).find("Curve V0 meets others, or has a knuckle, at (4.000, 0.000, 0.000) "
                               "m and again 5 mm further"),
            std::string::npos);
}

TEST(NetworkProblems, ACurveThatTurnsBackIsNamed) {
  auto curves = square();
  // Along a line, there, back and there again.
  NetworkCurve bent;
  bent.definition.name = "B";
  bent.definition.points = {{0, 5, 0}, {8, 5, 0}, {3, 5, 0}, {10, 5, 0}};
  curves.push_back(bent);
  const CurveNetwork network = network_of(curves);
  const auto kinds = kinds_of(network);
  EXPECT_NE(std::ranges::find(kinds, NetworkProblem::Kind::kHalt), kinds.end()) << told(network);
  EXPECT_THROW(network.patch(0), std::invalid_argument);
}

TEST(NetworkProblems, AClosedCurveAloneHasAnEdge) {
  NetworkCurve ring = curve_along("R", [](double t) {
    return Vector3d(std::cos(2 * std::numbers::pi * t), std::sin(2 * std::numbers::pi * t), 0);
  });
  const CurveNetwork network = network_of({ring});
  EXPECT_EQ(network.frame().joined.edges.size(), 1u);
  EXPECT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kFewSides});
}

TEST(NetworkProblems, ANodeWithoutATangentPlaneIsNamed) {
  // Of three lines through a point no one explains it.
  std::vector<NetworkCurve> curves = {line_between("A", {-1, 0, 0}, {1, 0, 0}),
                                      line_between("B", {0, -1, 0}, {0, 1, 0}),
                                      line_between("C", {-1, -1, -0.3}, {1, 1, 0.3})};
  const Vector3d ends[] = {{1, 0, 0},  {1, 1, 0.3},    {0, 1, 0},
                           {-1, 0, 0}, {-1, -1, -0.3}, {0, -1, 0}};
  for (std::size_t i = 0; i < 6; ++i) {
    curves.push_back(line_between("R" + std::to_string(i), ends[i], ends[(i + 1) % 6]));
  }
  const CurveNetwork network = network_of(curves);
  ASSERT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kNoTangentPlane}) << told(network);
  EXPECT_LT(network.problems()[0].places[0].norm(), 1e-12);
  EXPECT_EQ(network.problems()[0].curves, (std::vector{0, 1, 2}));
  EXPECT_EQ(network.regions().size(), 6u);
}

TEST(NetworkProblems, ACurveThatIsNoneIsNamed) {
  auto curves = square();
  curves[2].definition.points.resize(1);
  const CurveNetwork network = network_of(curves);
  ASSERT_EQ(kinds_of(network), std::vector{NetworkProblem::Kind::kShape});
  EXPECT_EQ(network.problems()[0].what, "Curve V0: it needs two points or more.");
  EXPECT_THROW(network_of(square(), 0.0), std::invalid_argument);
  EXPECT_THROW(network_of(square(), -1.0), std::invalid_argument);
}

// Whichever of both has the node's place: one that another curve meets is the nearer one.
TEST(NetworkProblems, KnucklesNearerThanTheToleranceLeaveTheCurveBesideThem) {
  for (std::size_t met : {1u, 2u}) {
    auto curves = square();
    NetworkCurve bent;
    bent.definition.name = "B";
    bent.definition.points = {
        {4, 0, 0}, {5, 5, 0}, {5 + 0.3 * kTol, 5 + 0.4 * kTol, 0}, {7, 7, 0}, {4, 10, 0}};
    bent.definition.knuckles = {1, 2};
    curves.push_back(bent);
    curves.push_back(line_between("W", {0, 5, 0}, bent.definition.points[met]));
    const CurveNetwork network = network_of(curves);
    const JoinedCurves& joined = network.frame().joined;
    const auto& pieces = network.shapes()[4].pieces;
    std::vector<int> on;
    for (std::size_t e = 0; e < joined.edges.size(); ++e) {
      if (joined.edges[e].curve != 4) continue;
      const auto piece = static_cast<std::size_t>(joined.edges[e].piece);
      on.push_back(joined.edges[e].piece);
      EXPECT_EQ(joined.edges[e].low, pieces[piece].begin()) << met;
      EXPECT_EQ(joined.edges[e].high, pieces[piece].end()) << met;
      const Vector3d middle = network.frame().shapes[e].evaluate(0.5, 0).row(0);
      const double foot = pieces[piece].nearest_parameter(middle);
      EXPECT_LT((pieces[piece].point(foot) - middle).norm(), kTol) << met;
    }
    EXPECT_EQ(on, (std::vector{0, 2})) << met;
    EXPECT_EQ(network.regions().size(), 3u) << told(network);
  }
}

TEST(NetworkProblems, AnOpenCurveMeetsItselfAlsoWithItsEnds) {
  auto curves = square();
  NetworkCurve bent;
  bent.definition.name = "B";
  bent.definition.points = {{0, 3, 0}, {8, 3, 0}, {8, 8, 0}, {4, 0, 0}};
  bent.definition.knuckles = {1, 2};
  curves.push_back(bent);
  const CurveNetwork network = network_of(curves);
  EXPECT_EQ(network.regions().size(), 3u) << told(network);
  int there = 0;
  for (const Vector3d& node : network.frame().joined.nodes) {
    there += (node - Vector3d(5.5, 3, 0)).norm() < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(there, 1);
  // One that is closed has its start and end for a node, and no other one.
  bent.definition.points = {{2, 2, 0}, {8, 2, 0}, {8, 8, 0}, {2, 2, 0}};
  EXPECT_EQ(network_of({bent}).frame().joined.nodes.size(), 3u);
}

TEST(NetworkProblems, LengthsAndPlacesAreToldAsOneReadsThem) {
  EXPECT_EQ(length_text(0.0004), "0.4 mm");
  EXPECT_EQ(length_text(0.9994), "999 mm");
  EXPECT_EQ(length_text(0.99999), "1.000 m");
  EXPECT_EQ(place_text({1.0, -1e-17, 2.5}), "(1.000, 0.000, 2.500) m");
}

}  // namespace
}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/neighbour_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include "random_values.h"

namespace hull::morphing {
namespace {

// A point, the first, with `edges` around it.
TriangleDisc star_with(const std::vector<Vector3d>& edges) {
  std::vector<Vector3d> points{{1.0, 2.0, 3.0}};
  std::vector<Triangle> triangles;
  const int count = static_cast<int>(edges.size());
  for (int k = 0; k < count; ++k) {
    points.push_back(points[0] + edges[k]);
    triangles.push_back({0, 1 + k, 1 + (k + 1) % count});
  }
  return {points, triangles};
}

std::vector<double> weights_by_point(const TriangleDisc& disc, WeightKind kind) {
  std::vector<double> weights(disc.points().size(), 0.0);
  for (const NeighbourWeight& of : neighbour_weights(disc, 0, kind)) weights[of.point] = of.weight;
  return {weights.begin() + 1, weights.end()};
}

std::vector<Vector3d> plane_star(const std::vector<double>& directions,
                                 const std::vector<double>& lengths) {
  std::vector<Vector3d> edges;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    edges.emplace_back(lengths[k] * std::cos(directions[k]), lengths[k] * std::sin(directions[k]),
                       0.0);
  }
  return edges;
}

TEST(NeighbourWeights, ThreeNeighboursHaveBarycentricWeights) {
  const TriangleDisc disc = star_with({{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-1.0, -1.0, 0.0}});
  const std::vector<double> weights = weights_by_point(disc, WeightKind::kShapePreserving);
  // Areas of the opposite triangles: 1, 2, 2.
  EXPECT_NEAR(weights[0], 0.2, 1e-15);
  EXPECT_NEAR(weights[1], 0.4, 1e-15);
  EXPECT_NEAR(weights[2], 0.4, 1e-15);
}

// Four edges at right angles: the line through a neighbour and the point meets the opposite one,
// and with either triangle the third weight is 0. By hand: of each pair the mean of (1 / r).
TEST(NeighbourWeights, ALineThroughANeighbourMayMeetAnother) {
  const TriangleDisc disc =
      star_with({{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {-3.0, 0.0, 0.0}, {0.0, -2.0, 0.0}});
  const std::vector<double> weights = weights_by_point(disc, WeightKind::kShapePreserving);
  EXPECT_NEAR(weights[0], 0.5 * 0.75, 1e-15);
  EXPECT_NEAR(weights[1], 0.5 * 0.5, 1e-15);
  EXPECT_NEAR(weights[2], 0.5 * 0.25, 1e-15);
  EXPECT_NEAR(weights[3], 0.5 * 0.5, 1e-15);
}

// A cone's angles are scaled to 2 pi: equal ones stay equal, whatever the cone.
TEST(NeighbourWeights, ConesAreLaidFlat) {
  for (double height : {-2.0, 0.0, 0.5, 5.0}) {
    std::vector<Vector3d> edges;
    for (int k = 0; k < 7; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 7;
      edges.emplace_back(std::cos(angle), std::sin(angle), height);
    }
    for (auto kind : {WeightKind::kShapePreserving, WeightKind::kMeanValue}) {
      for (double weight : weights_by_point(star_with(edges), kind)) {
        EXPECT_NEAR(weight, 1.0 / 7.0, 1e-14);
      }
    }
  }
}

// What both kinds are for: in a plane the point is the mean of its neighbours. In space weights are
// positive all the same.
TEST(NeighbourWeights, ArePositiveAndReproduceAPlane) {
  constexpr unsigned kSeed = 20261124;
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < 400; ++trial) {
    const int count = 3 + trial % 9;
    std::vector<double> directions, lengths;
    for (int k = 0; k < count; ++k) {
      const double within = testing::uniform(random, 0.1, 0.9);
      directions.push_back(2.0 * std::numbers::pi * (k + (count == 3 ? 0.3 : 1.0) * within) /
                           count);
      lengths.push_back(testing::uniform(random, 0.2, 2.0));
    }
    const std::vector<Vector3d> edges = plane_star(directions, lengths);
    std::vector<Vector3d> bent = edges;
    for (Vector3d& edge : bent) edge.z() = testing::uniform(random, -2.0, 2.0);
    for (auto kind : {WeightKind::kShapePreserving, WeightKind::kMeanValue}) {
      const std::vector<double> weights = weights_by_point(star_with(edges), kind);
      Vector3d mean = Vector3d::Zero();
      for (int k = 0; k < count; ++k) mean += weights[k] * edges[k];
      EXPECT_LT(mean.norm(), 1e-13) << "seed " << kSeed << ", trial " << trial;
      const std::vector<double> in_space = weights_by_point(star_with(bent), kind);
      for (double weight : in_space) {
        EXPECT_GT(weight, 0.0) << "seed " << kSeed << ", trial " << trial;
      }
      EXPECT_NEAR(std::accumulate(in_space.begin(), in_space.end(), 0.0), 1.0, 1e-14);
    }
  }
}

TEST(NeighbourWeights, WhereNoTriangleHasAreaThatIsTold) {
  const TriangleDisc disc = star_with({{1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}});
  for (auto kind : {WeightKind::kShapePreserving, WeightKind::kMeanValue}) {
    try {
      neighbour_weights(disc, 0, kind);
      ADD_FAILURE();
    } catch (const std::invalid_argument& fault) {
      EXPECT_STREQ(fault.what(), "The triangles around point 0 have no area: leave the point out.");
    }
  }
}

}  // namespace
}  // namespace hull::morphing

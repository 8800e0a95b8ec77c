// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/landmarks.h"

#include <gtest/gtest.h>

#include "morphing/features/feature_matching.h"
#include "morphing/half_hulls.h"

namespace hull::morphing {
namespace {

using Kinds = std::vector<LandmarkKind>;

const Feature& centre_line(const FeatureGraph& graph) { return graph.features.front(); }

Kinds kinds_of(const std::vector<Landmark>& landmarks) {
  Kinds kinds;
  for (const Landmark& each : landmarks) kinds.push_back(each.kind);
  return kinds;
}

TEST(FeatureGraph, TellsTheLinesOfAHalfHull) {
  const FeatureGraph graph = feature_graph(half_hull(plain_profile()));
  std::vector<FeatureRole> roles;
  for (const Feature& f : graph.features) roles.push_back(f.role);
  const std::vector<FeatureRole> expected{FeatureRole::kCentreLine, FeatureRole::kTransomRim,
                                          FeatureRole::kBowRim, FeatureRole::kDeckEdge};
  EXPECT_EQ(roles, expected);
  EXPECT_EQ(graph.body_count, 1);
  EXPECT_EQ(graph.described(0), "the centre line from (0.00, 0.00, 8.00) to (104.00, 0.00, 12.00)");
  EXPECT_EQ(graph.described_body(0),
            "the body between (0.00, 0.00, 0.00) and (104.00, 12.00, 14.00)");
}

TEST(Landmarks, OfAProfileWithABulb) {
  const FeatureGraph graph = feature_graph(half_hull(bulb_profile(5.0)));
  const std::vector<Landmark> found = landmarks(centre_line(graph), graph.box);
  ASSERT_EQ(kinds_of(found), (Kinds{LandmarkKind::kKeelBegin, LandmarkKind::kKeelEnd,
                                    LandmarkKind::kBulbTip, LandmarkKind::kBulbNeck}));
  // The nose: no place of the profile below the neck is farther forward, to the places' distance.
  const modelling::FieldCurve& curve = centre_line(graph).curve;
  const double tip = curve.point_at(found[2].length).x(), step = curve.length() / kProfilePlaces;
  for (double length = 0.0; length < found[3].length; length += 0.1) {
    EXPECT_LE(curve.point_at(length).x(), tip + step);
  }
  EXPECT_LT(std::abs(curve.tangent_at(found[2].length).x()), 0.1);
  EXPECT_LT(std::abs(curve.tangent_at(found[3].length).x()), 0.1);
}

TEST(Landmarks, OfAPlainStemAreThoseOfTheKeel) {
  const FeatureGraph graph = feature_graph(half_hull(plain_profile()));
  EXPECT_EQ(kinds_of(landmarks(centre_line(graph), graph.box)),
            (Kinds{LandmarkKind::kKeelBegin, LandmarkKind::kKeelEnd}));
  for (std::size_t i = 1; i < graph.features.size(); ++i) {
    EXPECT_TRUE(landmarks(graph.features[i], graph.box).empty());
  }
}

TEST(Landmarks, LayNosesOfBulbsOnOneAnother) {
  const FeatureGraph first = feature_graph(half_hull(bulb_profile(5.0)));
  const FeatureGraph second = feature_graph(half_hull(bulb_profile(8.0)));
  const FeatureMatch match = match_features(first, second);
  const LengthMap map = length_map(first, second, match, match.pairs.front());
  const std::vector<Landmark> own = landmarks(centre_line(first), first.box);
  const std::vector<Landmark> others = landmarks(centre_line(second), second.box);
  ASSERT_EQ(own.size(), others.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_NEAR(map(own[i].length), others[i].length, 1e-9);
  }
  for (std::size_t i = 1; i < map.first.size(); ++i) {
    EXPECT_LT(map.first[i - 1], map.first[i]);
    EXPECT_LT(map.second[i - 1], map.second[i]);
  }
}

TEST(Landmarks, ABulbHasNoCounterpartOnAPlainStem) {
  const FeatureGraph first = feature_graph(half_hull(bulb_profile(5.0)));
  const FeatureGraph second = feature_graph(half_hull(plain_profile()));
  EXPECT_EQ(common_landmarks(first, centre_line(first), second, centre_line(second)).size(), 2u);
}

}  // namespace
}  // namespace hull::morphing

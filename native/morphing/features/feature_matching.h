// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "morphing/features/feature_graph.h"

namespace hull::morphing {

// A feature of one hull, by its number, and what it is in the other.
struct FeaturePair {
  int first, second;
  // Root mean square distance of points at equal proportions of the lengths, each in the box of its
  // hull: 0 for the same place, 1 for one as far away as the hull is long, broad or high.
  double distance;
  bool is_given;  // by the user
};

// Of each body of the first hull that of the second, by the extent and the place of their boxes,
// the nearest ones first; -1: none.
std::vector<int> paired_bodies(const FeatureGraph& first, const FeatureGraph& second);

struct FeatureMatch {
  std::vector<FeaturePair> pairs;   // by the first hull's features
  std::vector<int> alone_in_first;  // features without counterpart, rising
  std::vector<int> alone_in_second;
  std::vector<std::string> remarks;  // a sentence for each of these, with the remedy
};

// Pairs features of two hulls: first those given, then of equal roles the nearest ones, one after
// the other. Features of a role that each body has once, but for knuckles, are paired wherever they
// lie; of others those within kFarthestPair. Bodies are those of paired_bodies(). Those held apart
// are in no pair unless it is given. Throws std::invalid_argument for given pairs that are none, or
// that name a feature twice.
FeatureMatch match_features(const FeatureGraph& first, const FeatureGraph& second,
                            const std::vector<std::array<int, 2>>& given = {},
                            const std::vector<std::array<int, 2>>& apart = {});
inline constexpr double kFarthestPair = 0.2;

// Where a feature of the first hull is in its counterpart: by equal proportions of lengths between
// nodes that both have, at which the same paired features meet, and between landmarks of profiles.
struct LengthMap {
  std::vector<double> first, second;  // lengths along the curves, m, both rising from 0

  double operator()(double length) const;
};
LengthMap length_map(const FeatureGraph& first, const FeatureGraph& second,
                     const FeatureMatch& match, const FeaturePair& pair);

}  // namespace hull::morphing

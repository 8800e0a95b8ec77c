// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "morphing/features/feature_graph.h"

namespace hull::morphing {

// What a place of a profile is to the ship.
enum class LandmarkKind {
  kArch,       // the profile turns aft again, above a stern bulb or gondola
  kSternEnd,   // and from there forward
  kKeelBegin,  // of a keel that is level over kLevelKeel of the length or more
  kKeelEnd,
  kBulbTip,  // the profile turns aft again, at the nose of a bulb
  kBulbNeck  // and from there forward
};

struct Landmark {
  LandmarkKind kind;
  double length;  // along the feature's curve, m
};

// The places of a line in the centre plane (centre line, edge of a bar keel) that profiles of ships
// have in common, in order; none of other lines. Found among kProfilePlaces places of the curve.
std::vector<Landmark> landmarks(const Feature& feature, const HullBox& hull);
inline constexpr int kProfilePlaces = 2000;
inline constexpr double kLevelKeel = 0.3;

// Pairs of lengths along two features at landmarks that both have as often at that end of the
// ship, rising; where one bow has a bulb and the other none, they have no tip in common.
std::vector<std::array<double, 2>> common_landmarks(const FeatureGraph& first, const Feature& f,
                                                    const FeatureGraph& second, const Feature& g);

}  // namespace hull::morphing

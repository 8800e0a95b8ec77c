// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/landmarks.h"

#include <algorithm>

namespace hull::morphing {
namespace {

// Of the length: how far a profile turns back at least where it has a bulb.
constexpr double kTurnsBack = 2e-3;
// Of the depth: how far a level keel is off its lowest point.
constexpr double kLevel = 0.01;

struct ProfilePlace {
  double length;
  Vector3d at;  // relative to the hull's box
};

std::vector<ProfilePlace> profile_places(const Feature& feature, const HullBox& hull) {
  std::vector<ProfilePlace> places;
  for (int i = 0; i <= kProfilePlaces; ++i) {
    const double length = feature.curve.length() * i / kProfilePlaces;
    places.push_back({length, hull.relative(feature.curve.point_at(length))});
  }
  return places;
}

// Where the profile turns back by kTurnsBack or more: foremost and aftermost places in turn.
void add_turns(const std::vector<ProfilePlace>& places, std::vector<Landmark>& found) {
  bool is_forward = true;
  const ProfilePlace* farthest = &places.front();
  for (const ProfilePlace& place : places) {
    // By hysteresis: waves of less than kTurnsBack do not turn it.
    const double beyond = (place.at.x() - farthest->at.x()) * (is_forward ? 1.0 : -1.0);
    if (beyond > 0.0) farthest = &place;
    if (beyond > -kTurnsBack) continue;
    // Profiles run from aft to forward: what a turn is follows from the end of the ship and its
    // sense.
    const bool is_aft = farthest->at.x() < 0.5;
    const LandmarkKind kind = is_forward
                                  ? (is_aft ? LandmarkKind::kArch : LandmarkKind::kBulbTip)
                                  : (is_aft ? LandmarkKind::kSternEnd : LandmarkKind::kBulbNeck);
    found.push_back({kind, farthest->length});
    farthest = &place;
    is_forward = !is_forward;
  }
}

void add_keel(const std::vector<ProfilePlace>& places, std::vector<Landmark>& found) {
  double low = places.front().at.z();
  for (const ProfilePlace& place : places) low = std::min(low, place.at.z());
  const auto is_level = [&](const ProfilePlace& place) { return place.at.z() <= low + kLevel; };
  // From the first level place to the last: what is between may rise.
  const auto begin = std::find_if(places.begin(), places.end(), is_level);
  const auto end = std::find_if(places.rbegin(), places.rend(), is_level);
  if (end->at.x() - begin->at.x() < kLevelKeel) return;
  found.push_back({LandmarkKind::kKeelBegin, begin->length});
  found.push_back({LandmarkKind::kKeelEnd, end->length});
}

std::vector<double> lengths_of(const std::vector<Landmark>& all, LandmarkKind kind) {
  std::vector<double> lengths;
  for (const Landmark& each : all) {
    if (each.kind == kind) lengths.push_back(each.length);
  }
  return lengths;
}

}  // namespace

std::vector<Landmark> landmarks(const Feature& feature, const HullBox& hull) {
  const bool is_profile =
      feature.role == FeatureRole::kCentreLine || feature.role == FeatureRole::kBarEdge;
  if (!is_profile || feature.closed()) return {};
  const std::vector<ProfilePlace> places = profile_places(feature, hull);
  std::vector<Landmark> found;
  add_turns(places, found);
  add_keel(places, found);
  std::stable_sort(found.begin(), found.end(),
                   [](const Landmark& a, const Landmark& b) { return a.length < b.length; });
  return found;
}

std::vector<std::array<double, 2>> common_landmarks(const FeatureGraph& first, const Feature& f,
                                                    const FeatureGraph& second, const Feature& g) {
  const std::vector<Landmark> own = landmarks(f, first.box), others = landmarks(g, second.box);
  std::vector<std::array<double, 2>> pairs;
  for (LandmarkKind kind :
       {LandmarkKind::kArch, LandmarkKind::kSternEnd, LandmarkKind::kKeelBegin,
        LandmarkKind::kKeelEnd, LandmarkKind::kBulbTip, LandmarkKind::kBulbNeck}) {
    const std::vector<double> here = lengths_of(own, kind), there = lengths_of(others, kind);
    // As often on both lines, else it is open which is which.
    if (here.size() != there.size()) continue;
    for (std::size_t i = 0; i < here.size(); ++i) pairs.push_back({here[i], there[i]});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace hull::morphing

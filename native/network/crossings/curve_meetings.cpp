// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/crossings/curve_meetings.h"

#include <algorithm>
#include <cmath>

#include "network/crossings/near_zones.h"
#include "network/crossings/nearest_pair.h"

namespace hull::network {
namespace {

constexpr int kLengthSteps = 32;

CurveMeeting meeting_at(const NurbsCurve& first, const NurbsCurve& second, double s, double t) {
  return {s, t, first.point(s), second.point(t)};
}

double length_between(const NurbsCurve& curve, double low, double high, int steps) {
  double length = 0.0;
  Vector3d before = curve.point(low);
  for (int i = 1; i <= steps; ++i) {
    const Vector3d next = curve.point(low + (high - low) * i / steps);
    length += (next - before).norm();
    before = next;
  }
  return length;
}

// The nearest pair of a coherent stretch: downhill from each of its zones.
CurveMeeting nearest_of(const NurbsCurve& first, const NurbsCurve& second,
                        const std::vector<NearZone>& zones) {
  // A stretch may have several minima, as where the curves cross twice within the reach.
  std::optional<CurveMeeting> best;
  for (const NearZone& zone : zones) {
    const auto [s, t] = nearest_pair(first, second, {zone.first_nearest, zone.second_nearest});
    const CurveMeeting meeting = meeting_at(first, second, s, t);
    if (!best || meeting.distance() < best->distance()) best = meeting;
  }
  return *best;
}

CurveOverlap stretch_of(const NurbsCurve& first, const NurbsCurve& second,
                        const std::vector<NearZone>& zones) {
  const NearZone& lowest = *std::ranges::min_element(zones, {}, &NearZone::first_low);
  const NearZone& highest = *std::ranges::max_element(zones, {}, &NearZone::first_high);
  // The second curve may run against the first: its ends may be in other zones.
  const double low = std::ranges::min(zones, {}, &NearZone::second_low).second_low;
  const double high = std::ranges::max(zones, {}, &NearZone::second_high).second_high;
  const bool is_along = first.evaluate(lowest.first_nearest, 1)
                            .row(1)
                            .dot(second.evaluate(lowest.second_nearest, 1).row(1)) >= 0.0;
  return {lowest.first_low, highest.first_high, is_along ? low : high, is_along ? high : low,
          // One zone is of straight parts.
          length_between(first, lowest.first_low, highest.first_high,
                         zones.size() > 1 ? kLengthSteps : 1),
          first.point(lowest.first_low), first.point(highest.first_high)};
}

}  // namespace

double longest_touch(const CurveTree& first, const CurveTree& second, double reach) {
  const double size = std::min(first.box().diagonal().norm(), second.box().diagonal().norm());
  return std::sqrt(8.0 * reach * size);
}

// Chords tell where to look, and how long it is; Newton's method on the curves tells the place.
CurveMeetings curve_meetings(CurveTree& first, CurveTree& second, double reach) {
  CurveMeetings meetings;
  const NurbsCurve &a = first.curve(), &b = second.curve();
  const double longest = longest_touch(first, second, reach);
  for (const auto& zones : coherent_zones(near_zones(first, second, reach))) {
    const CurveOverlap stretch = stretch_of(a, b, zones);
    // Where curves lie on one another any place is the nearest, but for rounding: that is no point.
    if (stretch.length > longest) {
      meetings.overlaps.push_back(stretch);
      continue;
    }
    const CurveMeeting nearest = nearest_of(a, b, zones);
    // Zones are of chords and a little wider: the curves themselves decide.
    if (nearest.distance() <= reach) meetings.points.push_back(nearest);
  }
  std::ranges::sort(meetings.points, {}, &CurveMeeting::first);
  std::ranges::sort(meetings.overlaps, {}, &CurveOverlap::first_low);
  return meetings;
}

}  // namespace hull::network

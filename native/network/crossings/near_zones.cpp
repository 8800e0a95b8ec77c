// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/crossings/near_zones.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hull::network {
namespace {

constexpr int kHalvings = 40;
// The square of the sine of the angle between lines: below it rounding of a c - b² is much of that.
constexpr double kParallelSquare = 1e-14;
// Of the largest parameter: neighbouring zones meet at limits that were computed twice.
constexpr double kSameLimit = 1e-12;

struct Segment {
  Vector3d start, way;

  Vector3d at(double share) const { return start + share * way; }
  double nearest_share(const Vector3d& place) const {
    const double square = way.squaredNorm();
    return square > 0.0 ? std::clamp(way.dot(place - start) / square, 0.0, 1.0) : 0.0;
  }
  double distance(const Vector3d& place) const { return (place - at(nearest_share(place))).norm(); }
};

// Along `along`, where it is nearest to `other`: the distance from a segment is convex there.
double nearest_on(const Segment& along, const Segment& other) {
  const Vector3d between = along.start - other.start;
  const double a = along.way.squaredNorm(), b = along.way.dot(other.way),
               c = other.way.squaredNorm();
  const double slope = along.way.dot(between), other_slope = other.way.dot(between);
  const double area = a * c - b * b;
  // Of the lines, else of the ends: of parallels any.
  std::vector<double> shares{0.0, 1.0, along.nearest_share(other.start),
                             along.nearest_share(other.at(1.0))};
  if (area > kParallelSquare * a * c) {
    shares.push_back(std::clamp((b * other_slope - c * slope) / area, 0.0, 1.0));
  }
  return *std::ranges::min_element(shares, {},
                                   [&](double share) { return other.distance(along.at(share)); });
}

// From where it is near to where it no longer is, or the end.
double limit(const Segment& along, const Segment& other, double from, double to, double reach) {
  // As the distance is convex, it leaves the reach once only: by halves to 1e-12 of the segment.
  if (other.distance(along.at(to)) <= reach) return to;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (from + to);
    (other.distance(along.at(middle)) <= reach ? from : to) = middle;
  }
  return from;
}

bool touch(double low, double high, double other_low, double other_high, double slack) {
  return low <= other_high + slack && other_low <= high + slack;
}

// Zones that touch on both curves: neighbours end at the same parameters but for rounding; on one
// curve alone they may be different meetings.
std::vector<std::pair<std::size_t, std::size_t>> touching_pairs(const std::vector<NearZone>& zones,
                                                                double first_slack,
                                                                double second_slack) {
  std::vector<std::size_t> order(zones.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return zones[i].first_low; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const NearZone& a = zones[order[i]];
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const NearZone& b = zones[order[k]];
      // None that begins later touches it, either: curves that lie on one another have thousands.
      if (b.first_low > a.first_high + first_slack) break;
      if (touch(a.second_low, a.second_high, b.second_low, b.second_high, second_slack)) {
        pairs.emplace_back(std::minmax(order[i], order[k]));
      }
    }
  }
  // By numbers, which the order of groups follows.
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

std::optional<SegmentZone> near_segments(const Vector3d& first_start, const Vector3d& first_end,
                                         const Vector3d& second_start, const Vector3d& second_end,
                                         double reach) {
  const Segment a{first_start, first_end - first_start};
  const Segment b{second_start, second_end - second_start};
  const double s = nearest_on(a, b);
  if (b.distance(a.at(s)) > reach) return std::nullopt;
  const double t = nearest_on(b, a);
  // The second's nearest place is that of the first's: along parallels t may be anywhere.
  return SegmentZone{
      limit(a, b, s, 0.0, reach), limit(a, b, s, 1.0, reach), s,
      limit(b, a, t, 0.0, reach), limit(b, a, t, 1.0, reach), b.nearest_share(a.at(s))};
}

// Down both trees at once: pairs of parts whose boxes are near, until both are straight.
std::vector<NearZone> near_zones(CurveTree& first, CurveTree& second, double reach) {
  std::vector<NearZone> zones;
  std::vector<std::pair<int, int>> pairs;
  // Straight parts are taken for their chords, from which both curves may be flat() away.
  const double far = reach + 2.0 * std::max(first.flat(), second.flat());
  // Of most pairs of curves this is all that is asked.
  if (first.box().squaredExteriorDistance(second.box()) > far * far) return zones;
  for (int i = 0; i < first.root_count(); ++i) {
    for (int k = 0; k < second.root_count(); ++k) pairs.emplace_back(i, k);
  }
  while (!pairs.empty()) {
    const auto [i, k] = pairs.back();
    pairs.pop_back();
    const CurveTree::Part &a = first.part(i), &b = second.part(k);
    if (a.box.squaredExteriorDistance(b.box) > far * far) continue;
    if (a.is_straight && b.is_straight) {
      const auto zone = near_segments(a.start, a.end, b.start, b.end, far);
      if (!zone) continue;
      const auto on = [](const CurvePiece& piece, double share) {
        return piece.low + share * (piece.high - piece.low);
      };
      // Limits rise on both curves, whichever way they run past one another.
      zones.push_back({on(a.piece, zone->first_low), on(a.piece, zone->first_high),
                       on(a.piece, zone->first_nearest), on(b.piece, zone->second_low),
                       on(b.piece, zone->second_high), on(b.piece, zone->second_nearest)});
      continue;
    }
    // The larger one is halved, so that both become alike: small boxes part soonest.
    const bool is_first = b.is_straight || (!a.is_straight && a.box.diagonal().squaredNorm() >=
                                                                  b.box.diagonal().squaredNorm());
    const int half = is_first ? first.halves_of(i) : second.halves_of(k);
    for (int side : {0, 1}) {
      pairs.emplace_back(is_first ? half + side : i, is_first ? k : half + side);
    }
  }
  return zones;
}

std::vector<std::vector<NearZone>> coherent_zones(const std::vector<NearZone>& zones) {
  // Classes as trees whose ways to the root are halved as they are gone.
  std::vector<std::size_t> root(zones.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto root_of = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  double first_size = 0.0, second_size = 0.0;
  for (const NearZone& zone : zones) {
    first_size = std::max({first_size, std::abs(zone.first_low), std::abs(zone.first_high)});
    second_size = std::max({second_size, std::abs(zone.second_low), std::abs(zone.second_high)});
  }
  for (const auto& [i, k] :
       touching_pairs(zones, kSameLimit * first_size, kSameLimit * second_size)) {
    root[root_of(i)] = root_of(k);
  }
  std::vector<std::vector<NearZone>> groups(zones.size());
  for (std::size_t i = 0; i < zones.size(); ++i) groups[root_of(i)].push_back(zones[i]);
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

}  // namespace hull::network

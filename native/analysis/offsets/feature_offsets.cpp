// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/feature_offsets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "analysis/offsets/line_planes.h"
#include "mesh/tolerances.h"
#include "surface/creases/crease_curves.h"

namespace hull::analysis {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kStepsPerEdge = 16;
// More than a parameter has bits: to the last of them.
constexpr int kHalvings = 60;
// Chains go on in one another where they turn by less than about 45 degrees.
constexpr double kStraightOn = -0.7;

using Chains = std::vector<surface::CreaseCurve>;

// Where a chain leaves its end vertex, and in which direction.
struct ChainEnd {
  int chain;
  Vector3d direction;
};

ChainEnd end_of(const Chains& chains, int chain, bool at_start) {
  const surface::CreaseCurve& curve = chains[chain];
  const double length = curve.edge_count();
  const double end = at_start ? 0.0 : length;
  const double inside = at_start ? std::min(0.05, length) : std::max(length - 0.05, 0.0);
  const Vector3d way = curve.evaluate(inside, 0).point - curve.evaluate(end, 0).point;
  return {chain, way.normalized()};
}

// The number of the group that each chain belongs to: chains that go on in one another.
std::vector<int> group_chains(const Chains& chains) {
  std::map<int, std::vector<ChainEnd>> ends;
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    if (chains[i].closed()) continue;
    ends[chains[i].vertices().front()].push_back(end_of(chains, i, true));
    ends[chains[i].vertices().back()].push_back(end_of(chains, i, false));
  }
  std::vector<int> group(chains.size());
  std::iota(group.begin(), group.end(), 0);
  const auto join = [&group](int a, int b) {
    const int kept = group[a], gone = group[b];
    for (int& number : group) {
      if (number == gone) number = kept;
    }
  };
  for (const auto& [vertex, meeting] : ends) {
    // Each goes on in at most one other, the straightest pair first.
    std::vector<bool> used(meeting.size(), false);
    while (true) {
      double straightest = kStraightOn;
      std::size_t first = 0, second = 0;
      for (std::size_t i = 0; i < meeting.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          // Both directions lead away from the point: -1 is straight on.
          const double turn = meeting[i].direction.dot(meeting[j].direction);
          const bool same_kind = chains[meeting[i].chain].kind() == chains[meeting[j].chain].kind();
          if (used[i] || used[j] || !same_kind || turn >= straightest) continue;
          straightest = turn;
          first = i;
          second = j;
        }
      }
      if (first == second) break;
      used[first] = used[second] = true;
      join(meeting[first].chain, meeting[second].chain);
    }
  }
  return group;
}

// The points of the chain at the station x, those nearer to its ends than `same` with it.
std::vector<Vector3d> points_at(const surface::CreaseCurve& chain, double x, double same) {
  std::vector<Vector3d> found;
  const int steps = chain.edge_count() * kStepsPerEdge;
  Vector3d previous = chain.evaluate(0.0, 0).point;
  if (std::abs(previous.x() - x) <= same) found.push_back(previous);
  for (int i = 1; i <= steps; ++i) {
    const Vector3d point = chain.evaluate(static_cast<double>(i) / kStepsPerEdge, 0).point;
    // Half-open, so that a sample at the very station is found once.
    if ((previous.x() < x) != (point.x() < x)) {
      double low = static_cast<double>(i - 1) / kStepsPerEdge;
      double high = static_cast<double>(i) / kStepsPerEdge;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        const bool before = chain.evaluate(middle, 0).point.x() < x;
        // Whichever way the chain runs, the lower end stays on the side of the sample before.
        (before == (previous.x() < x) ? low : high) = middle;
      }
      found.push_back(chain.evaluate(0.5 * (low + high), 0).point);
    }
    previous = point;
  }
  if (std::abs(previous.x() - x) <= same) found.push_back(previous);
  return found;
}

struct Measured {
  FeatureOffsets offsets;
  double mean_height;
};

// The extents of a chain that decide whether it is a feature of the table.
bool runs_along_off_centre(const surface::CreaseCurve& chain, double size) {
  double most = 0.0, low = chain.evaluate(0.0, 0).point.x(), high = low;
  const int steps = chain.edge_count() * kStepsPerEdge;
  for (int i = 0; i <= steps; ++i) {
    const Vector3d point = chain.evaluate(static_cast<double>(i) / kStepsPerEdge, 0).point;
    most = std::max(most, point.y());
    low = std::min(low, point.x());
    high = std::max(high, point.x());
  }
  // Keel, stem and stern are the table's buttock 0; what lies across the ship has no point at a
  // station, or all of them.
  return most > kAtCentreLine * size && high - low > kSamePosition * size;
}

void name_in_order(std::vector<Measured>& features) {
  // Stable: features at one height keep the order of the mesh.
  std::stable_sort(features.begin(), features.end(), [](const Measured& a, const Measured& b) {
    return a.mean_height < b.mean_height;
  });
  const auto is_border = [](const Measured& m) {
    return m.offsets.kind == surface::CreaseKind::kBorder;
  };
  const auto borders = std::count_if(features.begin(), features.end(), is_border);
  int edge = 0, knuckle = 0;
  for (Measured& feature : features) {
    if (!is_border(feature)) {
      feature.offsets.name = "Knuckle " + std::to_string(++knuckle);
    } else if (borders == 1) {
      feature.offsets.name = "Deck edge";
    } else {
      feature.offsets.name = "Edge " + std::to_string(++edge);
    }
  }
}

}  // namespace

std::vector<FeatureOffsets> feature_offsets(const surface::LimitSurface& surface,
                                            const std::vector<double>& stations) {
  const double size = surface.mesh().size();
  const double same = kSamePosition * size;
  const Chains chains = surface::crease_curves(surface);
  const std::vector<int> groups = group_chains(chains);
  std::map<int, std::vector<int>> members;
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    if (runs_along_off_centre(chains[i], size)) members[groups[i]].push_back(i);
  }
  std::vector<Measured> features;
  for (const auto& [group, of_group] : members) {
    FeatureOffsets offsets{"", chains[of_group.front()].kind(), {}, {}};
    double sum = 0.0;
    int count = 0;
    for (const double x : stations) {
      // A breadth below all that count, and no height until there is one.
      Vector3d best(x, -1.0, kNone);
      for (const int chain : of_group) {
        for (const Vector3d& point : points_at(chains[chain], x, same)) {
          // Of a whole hull the starboard half is left out, but for rounding at the centre plane.
          if (point.y() >= -same && point.y() > best.y()) best = point;
        }
      }
      const bool found = std::isfinite(best.z());
      offsets.half_breadths.push_back(found ? std::max(best.y(), 0.0) : kNone);
      offsets.heights.push_back(best.z());
      if (found) sum += best.z();
      if (found) ++count;
    }
    // A feature between two stations has no column.
    if (count > 0) features.push_back({std::move(offsets), sum / count});
  }
  name_in_order(features);
  std::vector<FeatureOffsets> named;
  for (Measured& feature : features) named.push_back(std::move(feature.offsets));
  return named;
}

}  // namespace hull::analysis

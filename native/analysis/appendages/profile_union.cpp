// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/profile_union.h"

#include <algorithm>
#include <limits>

namespace hull::analysis {
namespace {

constexpr double kNoWidth = 1e-13;  // of the whole range

// A line that runs forward; `way` is -1 where its outline runs aft along it.
struct ProfileEdge {
  Vector2d from, to;
  int outline, way;

  double at(double x) const {
    return from.y() + (to.y() - from.y()) * ((x - from.x()) / (to.x() - from.x()));
  }
};

struct LengthRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

// Between which x the union may be another than the sum.
LengthRange length_range_of(const std::vector<ProfileOutline>& outlines) {
  const auto is_hull = [](const ProfileOutline& o) { return o.role == MemberRole::kHull; };
  const bool several = std::count_if(outlines.begin(), outlines.end(), is_hull) > 1;
  LengthRange range;
  for (const ProfileOutline& outline : outlines) {
    // A hull alone is its own union: only where something else is seen may anything differ.
    if (is_hull(outline) && !several) continue;
    for (const auto& line : outline.lines) {
      for (const Vector2d& p : line) {
        range.low = std::min(range.low, p.x());
        range.high = std::max(range.high, p.x());
      }
    }
  }
  return range;
}

std::vector<ProfileEdge> edges_within(const std::vector<ProfileOutline>& outlines,
                                      const LengthRange& range) {
  std::vector<ProfileEdge> edges;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    for (const auto& [a, b] : outlines[k].lines) {
      // Upright lines have no edges: strips between breaks have upright sides of their own.
      if (a.x() == b.x()) continue;
      const bool forward = a.x() < b.x();
      const ProfileEdge edge{forward ? a : b, forward ? b : a, static_cast<int>(k),
                             forward ? 1 : -1};
      if (edge.from.x() < range.high && edge.to.x() > range.low) edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const ProfileEdge& a, const ProfileEdge& b) { return a.from.x() < b.from.x(); });
  return edges;
}

// Of two edges of different outlines, where they cross.
void add_crossings(const std::vector<ProfileEdge>& edges, std::vector<double>& breaks) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const ProfileEdge &a = edges[i], &b = edges[j];
      // Edges are sorted by where they begin: none of the following meets this one either.
      if (b.from.x() >= a.to.x()) break;
      if (a.outline == b.outline) continue;
      const double begin = b.from.x(), end = std::min(a.to.x(), b.to.x());
      const double first = a.at(begin) - b.at(begin), last = a.at(end) - b.at(end);
      // Edges that only touch keep their order.
      if (first * last < 0.0) breaks.push_back(begin + (end - begin) * first / (first - last));
    }
  }
}

// All x between which edges neither begin, nor end, nor cross.
std::vector<double> breaks_of(const std::vector<ProfileEdge>& edges, const LengthRange& range) {
  std::vector<double> breaks{range.low, range.high};
  for (const ProfileEdge& edge : edges) {
    breaks.push_back(edge.from.x());
    breaks.push_back(edge.to.x());
  }
  add_crossings(edges, breaks);
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> kept;
  for (double x : breaks) {
    if (x < range.low || x > range.high) continue;
    if (kept.empty() || x - kept.back() > kNoWidth * (range.high - range.low)) kept.push_back(x);
  }
  return kept;
}

// For each stretch between breaks the edges over its middle.
std::vector<std::vector<const ProfileEdge*>> edges_over(const std::vector<ProfileEdge>& edges,
                                                        const std::vector<double>& breaks) {
  std::vector<std::vector<const ProfileEdge*>> over(breaks.size() - 1);
  const auto middle = [&](std::size_t k) { return 0.5 * (breaks[k] + breaks[k + 1]); };
  for (const ProfileEdge& edge : edges) {
    const auto first = std::upper_bound(breaks.begin(), breaks.end(), edge.from.x());
    std::size_t k = first == breaks.begin() ? 0 : first - breaks.begin() - 1;
    for (; k < over.size() && middle(k) < edge.to.x(); ++k) {
      if (middle(k) > edge.from.x()) over[k].push_back(&edge);
    }
  }
  return over;
}

// What is counted of a place inside of some outlines more than the hull's bodies count it.
int times_more(const std::vector<ProfileOutline>& outlines, const std::vector<int>& winding) {
  int bodies = 0;
  bool is_added = false, is_cut = false;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    if (winding[k] == 0) continue;
    if (outlines[k].role == MemberRole::kHull) ++bodies;
    if (outlines[k].role == MemberRole::kAdded) is_added = true;
    if (outlines[k].role == MemberRole::kCut) is_cut = true;
  }
  return ((bodies > 0 || is_added) && !is_cut ? 1 : 0) - bodies;
}

}  // namespace

std::vector<ProfilePart> profile_union(const std::vector<ProfileOutline>& outlines) {
  std::vector<ProfilePart> parts;
  const LengthRange range = length_range_of(outlines);
  if (!(range.high > range.low)) return parts;
  const std::vector<ProfileEdge> edges = edges_within(outlines, range);
  const std::vector<double> breaks = breaks_of(edges, range);
  std::vector<std::vector<const ProfileEdge*>> over = edges_over(edges, breaks);
  std::vector<int> winding(outlines.size());
  for (std::size_t k = 0; k < over.size(); ++k) {
    const double begin = breaks[k], end = breaks[k + 1], middle = 0.5 * (begin + end);
    // Outlines do not cross within a strip: the order at its middle is that of all of it.
    std::sort(over[k].begin(), over[k].end(), [&](const ProfileEdge* a, const ProfileEdge* b) {
      return a->at(middle) < b->at(middle);
    });
    std::fill(winding.begin(), winding.end(), 0);
    for (std::size_t i = 0; i + 1 < over[k].size(); ++i) {
      const ProfileEdge &below = *over[k][i], &above = *over[k][i + 1];
      // From below upwards each edge crossed changes by one how often its outline goes round a
      // place.
      winding[below.outline] += below.way;
      const int times = times_more(outlines, winding);
      if (times == 0) continue;
      parts.push_back({{begin, end},
                       {below.at(begin), below.at(end)},
                       {above.at(begin), above.at(end)},
                       times});
    }
  }
  return parts;
}

}  // namespace hull::analysis

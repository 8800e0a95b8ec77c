// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/section_point.h"

namespace hull::analysis {

// Arcs joined end to end: numbers of arcs, in order.
struct SectionChain {
  struct Link {
    int arc;
    bool reversed;
    int spot;  // through which the next link is reached, or -1
  };
  std::vector<Link> links;
  bool closed;
};

// How far apart ends may be that are joined.
struct JoinTolerances {
  double same;  // rounding: for any ends, m
  double gap;   // for ends that else would stay loose, where sides nearly lie in the plane
};

// Joins arcs, nearest ends first. Directed arcs follow one another, by way of following ones, if
// any; those of either sense are joined with each other only. may_end(point) tells ends that need
// no fellow, at borders of the surface: they are not joined over gaps.
template <class MayEnd>
std::vector<SectionChain> join_arcs(const SectionParts& parts, const JoinTolerances& tolerances,
                                    const MayEnd& may_end);

namespace section_chains_internal {

struct End {
  double along;  // coordinate by which ends are sorted
  int index;     // 2 * arc, + 1 for its last point
};

class Matcher {
 public:
  Matcher(const SectionParts& parts, double tolerance);
  const SectionPoint& point(int end) const;
  bool is_loose(int end) const { return partner_[end] < 0; }
  int end_count() const { return static_cast<int>(partner_.size()); }
  // Joins loose ends of the list, nearest first, that are no further apart than the tolerance.
  void match(std::vector<End>& ends, double tolerance, int spot);
  End end(int index) const;
  std::vector<SectionChain> chains() const;

 private:
  struct Meeting {
    double distance;
    int a, b;
  };
  bool fit(int a, int b) const;
  // Runs through the chain as its arcs want it.
  void turn_round(SectionChain& chain) const;

  const SectionParts& parts_;
  std::vector<int> partner_, spot_;  // by end
  std::vector<Meeting> meetings_;
};

}  // namespace section_chains_internal

template <class MayEnd>
std::vector<SectionChain> join_arcs(const SectionParts& parts, const JoinTolerances& tolerances,
                                    const MayEnd& may_end) {
  using namespace section_chains_internal;
  Matcher matcher(parts, tolerances.same);
  std::vector<End> loose;
  for (int s = 0; s < static_cast<int>(parts.spots.size()); ++s) {
    const SectionSpot& spot = parts.spots[s];
    loose.clear();
    for (int i = 0; i < matcher.end_count(); ++i) {
      if (!matcher.is_loose(i)) continue;
      if ((matcher.point(i).point - spot.knot.point).norm() > spot.radius) continue;
      loose.push_back(matcher.end(i));
    }
    matcher.match(loose, 2.0 * spot.radius, s);
  }
  loose.clear();
  for (int i = 0; i < matcher.end_count(); ++i) {
    if (matcher.is_loose(i) && !may_end(matcher.point(i))) loose.push_back(matcher.end(i));
  }
  matcher.match(loose, tolerances.gap, -1);
  return matcher.chains();
}

}  // namespace hull::analysis

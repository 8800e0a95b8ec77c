// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_chains.h"

#include <algorithm>
#include <tuple>

namespace hull::analysis::section_chains_internal {
namespace {

// Along a direction, of about unit length, that no usual plane is square to, few ends share a
// coordinate.
double along(const Vector3d& p) { return 0.61 * p.x() + 0.53 * p.y() + 0.59 * p.z(); }

}  // namespace

Matcher::Matcher(const SectionParts& parts, double tolerance)
    : parts_(parts), partner_(2 * parts.arcs.size(), -1), spot_(2 * parts.arcs.size(), -1) {
  std::vector<End> ends;
  ends.reserve(partner_.size());
  for (int i = 0; i < end_count(); ++i) ends.push_back(end(i));
  match(ends, tolerance, -1);
}

const SectionPoint& Matcher::point(int end) const {
  const SectionArc& arc = parts_.arcs[end / 2];
  return parts_.points[end % 2 == 0 ? arc.first : arc.last - 1];
}

End Matcher::end(int index) const { return {along(point(index).point), index}; }

bool Matcher::fit(int a, int b) const {
  const SectionArc& arc = parts_.arcs[a / 2];
  // An arc is closed only if it goes somewhere in between.
  if (a / 2 == b / 2) {
    const Vector3d& middle = parts_.points[(arc.first + arc.last) / 2].point;
    if ((middle - point(a).point).norm() < 2.0 * (point(a).point - point(b).point).norm()) {
      return false;
    }
  }
  using Sense = SectionArc::Sense;
  const Sense sense_a = arc.sense, sense_b = parts_.arcs[b / 2].sense;
  // Lines with one side of the plane on both sides go on with their like only; directed arcs go on
  // from a last point to a first.
  if ((sense_a == Sense::kEither) != (sense_b == Sense::kEither)) return false;
  return a % 2 != b % 2 || sense_a != Sense::kDirected || sense_b != Sense::kDirected;
}

void Matcher::match(std::vector<End>& ends, double tolerance, int spot) {
  std::sort(ends.begin(), ends.end(), [](const End& x, const End& y) { return x.along < y.along; });
  meetings_.clear();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      // The direction's length is 1.0006: nothing that is near enough is missed.
      if (ends[j].along - ends[i].along > 1.001 * tolerance) break;
      if (!fit(ends[i].index, ends[j].index)) continue;
      const double distance = (point(ends[i].index).point - point(ends[j].index).point).norm();
      if (distance <= tolerance) meetings_.push_back({distance, ends[i].index, ends[j].index});
    }
  }
  // Each end is joined to the nearest that is free; equally near ones go by their numbers.
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& x, const Meeting& y) {
    return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
  });
  for (const Meeting& m : meetings_) {
    if (partner_[m.a] >= 0 || partner_[m.b] >= 0) continue;
    partner_[m.a] = m.b;
    partner_[m.b] = m.a;
    spot_[m.a] = spot_[m.b] = spot;
  }
}

void Matcher::turn_round(SectionChain& chain) const {
  int directed = 0, following = 0;
  for (const auto& link : chain.links) {
    const SectionArc::Sense sense = parts_.arcs[link.arc].sense;
    const int way = link.reversed ? -1 : 1;
    if (sense == SectionArc::Sense::kDirected) directed += way;
    if (sense == SectionArc::Sense::kFollowing) following += way;
  }
  // Most of the directed arcs decide; those that follow have a say where these are at a tie.
  if (directed > 0 || (directed == 0 && following >= 0)) return;
  // A link tells of the spot after it.
  std::vector<SectionChain::Link> links;
  const std::size_t count = chain.links.size();
  for (std::size_t i = count; i-- > 0;) {
    const auto& link = chain.links[i];
    links.push_back({link.arc, !link.reversed, chain.links[(i + count - 1) % count].spot});
  }
  chain.links = std::move(links);
}

std::vector<SectionChain> Matcher::chains() const {
  std::vector<char> used(parts_.arcs.size(), 0);
  std::vector<SectionChain> chains;
  for (int i = 0; i < static_cast<int>(used.size()); ++i) {
    if (used[i]) continue;
    // Back to the beginning of the curve, or round to where we are.
    int begin = 2 * i;
    while (partner_[begin] >= 0) {
      // The other end of the arc before.
      begin = partner_[begin] ^ 1;
      if (begin == 2 * i) break;
    }
    SectionChain& chain = chains.emplace_back();
    chain.closed = partner_[begin] >= 0;
    for (int end = begin; end >= 0 && !used[end / 2]; end = partner_[end ^ 1]) {
      used[end / 2] = 1;
      chain.links.push_back({end / 2, end % 2 == 1, spot_[end ^ 1]});
    }
    turn_round(chain);
  }
  return chains;
}

}  // namespace hull::analysis::section_chains_internal

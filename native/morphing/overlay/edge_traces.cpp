// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/edge_traces.h"

#include <stdexcept>

namespace hull::morphing {
namespace {

// Walks every inner edge once, from the border inwards, so that it begins where its first point was
// found.
class Tracer {
 public:
  Tracer(const std::array<const DiscMap*, 2>& maps, const CommonBorder& border, int disc)
      : t_(maps[disc]->disc().topology()),
        other_(maps[1 - disc]->disc().topology()),
        places_(border.places[disc]),
        ground_{&other_, &border.places[1 - disc]},
        is_found_(t_.vertex_count(), 0),
        is_walked_(t_.edge_count(), 0) {
    traces_.locations.resize(t_.vertex_count());
    // All walks begin from what is known of the border.
    for (const CommonBorderPoint& at : border.points) {
      const int point = at.points[disc], other = at.points[1 - disc];
      if (point < 0) continue;
      // A border point of one disc alone is within the other's edge there.
      take(point, other >= 0 ? Location{Within::kPoint, other}
                             : Location{Within::kEdge, at.half_edges[1 - disc]});
    }
  }

  EdgeTraces run() {
    for (std::size_t i = 0; i < waiting_.size(); ++i) walk_from(waiting_[i]);
    return std::move(traces_);
  }

 private:
  void take(int point, const Location& location) {
    traces_.locations[point] = location;
    is_found_[point] = 1;
    waiting_.push_back(point);
  }

  void walk_from(int point) {
    // To the left from the outgoing half-edge; of a border point that is the one along the border,
    // and the turn ends at the border's other edge.
    const int begin = t_.outgoing(point);
    int h = begin;
    while (true) {
      if (t_.twin(h) >= 0 && !is_walked_[t_.edge(h)]) walk_edge(h);
      h = t_.twin(t_.prev(h));
      if (h < 0 || h == begin) return;
    }
  }

  void walk_edge(int h) {
    is_walked_[t_.edge(h)] = 1;
    const int from = t_.origin(h), to = t_.origin(t_.next(h));
    const bool is_border = t_.twin(t_.outgoing(to)) < 0;
    const int begin = static_cast<int>(traces_.stretches.size());
    // The border is a chain off the edges' lines: signs do not tell where a walk meets it.
    walk(ground_, traces_.locations[from], places_[from], places_[to],
         is_border ? &traces_.locations[to] : nullptr, traces_.stretches);
    const int count = static_cast<int>(traces_.stretches.size()) - begin;
    traces_.paths.push_back({h, begin, count});
    // A point is found by the first walk that comes to it; all others must find it in the same
    // place.
    const Location& end = traces_.stretches.back().end;
    if (!is_found_[to]) {
      take(to, end);
    } else if (!are_same(end, traces_.locations[to])) {
      throw std::logic_error("Two walks to one point end in different places.");
    }
  }

  bool are_same(const Location& a, const Location& b) const {
    if (a.within != b.within) return false;
    if (a.within != Within::kEdge) return a.index == b.index;
    return other_.edge(a.index) == other_.edge(b.index);
  }

  const mesh::Topology &t_, &other_;
  const std::vector<Vector2d>& places_;
  PlaneMesh ground_;
  std::vector<char> is_found_, is_walked_;
  std::vector<int> waiting_;
  EdgeTraces traces_;
};

}  // namespace

EdgeTraces trace_edges(const std::array<const DiscMap*, 2>& maps, const CommonBorder& border,
                       int disc) {
  return Tracer(maps, border, disc).run();
}

}  // namespace hull::morphing

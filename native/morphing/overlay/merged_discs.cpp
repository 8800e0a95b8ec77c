// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/merged_discs.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "morphing/overlay/merged_points.h"

namespace hull::morphing {
namespace {

using DiscPair = std::array<const DiscMap*, 2>;

// An edge of the merged mesh with the part of a triangle of each disc that is to its left.
struct PartSide {
  std::array<int, 2> triangles;
  int from, to;
};

// Both directions of all stretches of a disc's inner edges.
void add_inner_sides(const DiscPair& maps, const EdgeTraces& traces, int disc,
                     const MergedPoints& merged, std::vector<PartSide>& sides) {
  const mesh::Topology& own = maps[disc]->disc().topology();
  const mesh::Topology& other = maps[1 - disc]->disc().topology();
  const auto pair = [disc](int mine, int others) {
    return disc == 0 ? std::array<int, 2>{mine, others} : std::array<int, 2>{others, mine};
  };
  for (const EdgeTrace& path : traces.paths) {
    const int h = path.half_edge, left = own.face(h), right = own.face(own.twin(h));
    int from = merged.numbers[disc][own.origin(h)];
    for (int i = path.begin; i < path.begin + path.count; ++i) {
      const Stretch& stretch = traces.stretches[i];
      const bool is_last = i + 1 == path.begin + path.count;
      // A walk ends in its own edge's end, passes points of the other disc, and crosses edges.
      const int to = is_last ? merged.numbers[disc][own.origin(own.next(h))]
                     : stretch.end.within == Within::kPoint
                         ? merged.numbers[1 - disc][stretch.end.index]
                         : merged.number_of(pair(own.edge(h), other.edge(stretch.end.index)));
      // A stretch in a triangle has a part of it on either side, one with each triangle of its own
      // disc.
      if (stretch.triangle >= 0) {
        sides.push_back({pair(left, stretch.triangle), from, to});
        sides.push_back({pair(right, stretch.triangle), to, from});
      } else if (disc == 0) {  // both discs walk along the other's edge: one is enough
        const int along = stretch.half_edge;
        sides.push_back({{left, other.face(along)}, from, to});
        sides.push_back({{right, other.face(other.twin(along))}, to, from});
      }
      from = to;
    }
  }
}

void add_border_sides(const DiscPair& maps, const CommonBorder& border, const MergedPoints& merged,
                      std::vector<PartSide>& sides) {
  const auto number = [&](const CommonBorderPoint& at) {
    return at.points[0] >= 0 ? merged.numbers[0][at.points[0]] : merged.numbers[1][at.points[1]];
  };
  const std::size_t count = border.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const CommonBorderPoint& at = border.points[i];
    // In one direction: beyond the border there is nothing.
    sides.push_back({{maps[0]->disc().topology().face(at.half_edges[0]),
                      maps[1]->disc().topology().face(at.half_edges[1])},
                     number(at),
                     number(border.points[(i + 1) % count])});
  }
}

// The corners of a part in order, from that of the least place: so that it is cut into the same
// triangles whichever disc is the first.
std::vector<int> outline(const PartSide* begin, const PartSide* end,
                         const std::vector<Vector2d>& places) {
  const PartSide* side = std::min_element(begin, end, [&](const PartSide& a, const PartSide& b) {
    const Vector2d &p = places[a.from], &q = places[b.from];
    return std::make_tuple(p.x(), p.y()) < std::make_tuple(q.x(), q.y());
  });
  std::vector<int> corners;
  for (const PartSide* each = begin; each != end; ++each) {
    corners.push_back(side->from);
    side = std::find_if(begin, end, [&](const PartSide& other) { return other.from == side->to; });
    if (side == end) throw std::logic_error("A part of two triangles is not closed.");
  }
  if (side->from != corners.front() || corners.size() < 3) {
    throw std::logic_error("A part of two triangles has more than one outline.");
  }
  return corners;
}

}  // namespace

// The common part of a triangle of each disc is convex. Its sides are stretches of walks and of the
// border; those of one pair of triangles, put in order, are its outline.
MergedDiscs::MergedDiscs(const DiscMap& first, const DiscMap& second) {
  const DiscPair maps{&first, &second};
  const CommonBorder border = common_border(first, second);
  const std::array<EdgeTraces, 2> traces{trace_edges(maps, border, 0),
                                         trace_edges(maps, border, 1)};
  const MergedPoints merged = merged_points(maps, traces);
  MergedPositions positions = merged_positions(maps, border, traces, merged);
  places_ = std::move(positions.places);
  points_ = std::move(positions.points);
  shared_count_ = merged.shared_count;
  crossing_count_ = static_cast<int>(merged.crossings.size());
  origins_.assign(places_.size(), {-1, -1});
  for (int disc = 0; disc < 2; ++disc) {
    for (std::size_t i = 0; i < merged.numbers[disc].size(); ++i) {
      origins_[merged.numbers[disc][i]][disc] = static_cast<int>(i);
    }
  }
  std::vector<PartSide> sides;
  for (int disc = 0; disc < 2; ++disc) add_inner_sides(maps, traces[disc], disc, merged, sides);
  add_border_sides(maps, border, merged, sides);
  // Sides of one part come together; in which order is no matter, for outline() follows their ends.
  std::sort(sides.begin(), sides.end(),
            [](const PartSide& a, const PartSide& b) { return a.triangles < b.triangles; });
  const PartSide* const end = sides.data() + sides.size();
  for (const PartSide* side = sides.data(); side != end;) {
    // Sides of one pair of triangles are those of their common part.
    const PartSide* next = side;
    while (next != end && next->triangles == side->triangles) ++next;
    // A part is convex, and has no corner on a side: any fan will do.
    const std::vector<int> corners = outline(side, next, places_);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles_.push_back({corners[0], corners[i - 1], corners[i]});
      parents_.push_back(side->triangles);
    }
    side = next;
  }
}

std::vector<Vector3d> MergedDiscs::points(double t) const {
  std::vector<Vector3d> points(places_.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = (1.0 - t) * points_[0][i] + t * points_[1][i];
  }
  return points;
}

}  // namespace hull::morphing

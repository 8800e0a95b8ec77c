// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/merged_points.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hull::morphing {
namespace {

constexpr std::size_t kMostCrossings = 50'000'000;

void find_crossings(const std::array<const DiscMap*, 2>& maps, const EdgeTraces& second,
                    std::vector<std::array<int, 2>>& crossings) {
  const mesh::Topology &t = maps[0]->disc().topology(), &u = maps[1]->disc().topology();
  for (const EdgeTrace& path : second.paths) {
    // The last stretch ends at a point of the second disc.
    for (int i = path.begin; i + 1 < path.begin + path.count; ++i) {
      // The second disc's walks alone: those of the first meet the same edges.
      const Location& at = second.stretches[i].end;
      if (at.within != Within::kEdge) continue;
      crossings.push_back({t.edge(at.index), u.edge(path.half_edge)});
    }
    if (crossings.size() > kMostCrossings) {
      throw std::invalid_argument(
          "The edges of the two discs cross more than 50000000 times: take coarser triangles.");
    }
  }
  std::sort(crossings.begin(), crossings.end());
}

// An edge of a mapped disc in the plane and in space, in the direction of its front half-edge.
struct MappedEdge {
  std::array<Vector2d, 2> places;
  std::array<Vector3d, 2> points;
};

// Half-edges by edge, the front ones.
std::vector<int> fronts_of(const mesh::Topology& t) {
  std::vector<int> fronts(t.edge_count());
  for (int h = 0; h < t.half_edge_count(); ++h) {
    if (t.is_edge_front(h)) fronts[t.edge(h)] = h;
  }
  return fronts;
}

// The places and points of one disc.
class PlacedDisc {
 public:
  PlacedDisc(const DiscMap& map, const std::vector<Vector2d>& places)
      : disc_(map.disc()), places_(places), fronts_(fronts_of(disc_.topology())) {}

  MappedEdge edge(int edge) const {
    const mesh::Topology& t = disc_.topology();
    const int h = fronts_[edge], from = t.origin(h), to = t.origin(t.next(h));
    return {{places_[from], places_[to]}, {disc_.points()[from], disc_.points()[to]}};
  }

  Vector3d point_at(const Location& at, const Vector2d& place) const {
    switch (at.within) {
      case Within::kPoint:
        return disc_.points()[at.index];
      case Within::kEdge:
        return on_edge(edge(disc_.topology().edge(at.index)), place);
      default:
        return in_triangle(at.index, place);
    }
  }

 private:
  static Vector3d on_edge(const MappedEdge& edge, const Vector2d& place) {
    const Vector2d whole = edge.places[1] - edge.places[0];
    // By the longer axis, along which rounding of the place counts least.
    const int axis = std::abs(whole.x()) >= std::abs(whole.y()) ? 0 : 1;
    const double along = (place - edge.places[0])[axis] / whole[axis];
    return edge.points[0] + along * (edge.points[1] - edge.points[0]);
  }

  Vector3d in_triangle(int triangle, const Vector2d& place) const {
    const auto [a, b, c] = disc_.triangle(triangle);
    const double at_a = orientation(places_[b], places_[c], place);
    const double at_b = orientation(places_[c], places_[a], place);
    const double at_c = orientation(places_[a], places_[b], place);
    const std::vector<Vector3d>& p = disc_.points();
    // As differences from a corner: a coordinate that all three have alike stays bit by bit.
    return p[a] + (at_b * (p[b] - p[a]) + at_c * (p[c] - p[a])) / (at_a + at_b + at_c);
  }

  const TriangleDisc& disc_;
  const std::vector<Vector2d>& places_;
  std::vector<int> fronts_;
};

// How far along an edge it crosses another one.
double crossing_along(const MappedEdge& edge, const MappedEdge& other) {
  // Distances of both ends from the other edge's line, times its length.
  const double before = std::abs(orientation(other.places[0], other.places[1], edge.places[0]));
  const double after = std::abs(orientation(other.places[0], other.places[1], edge.places[1]));
  return before / (before + after);
}

}  // namespace

int MergedPoints::number_of(const std::array<int, 2>& edges) const {
  // An edge of each disc crosses an edge of the other once at most, and crossings are sorted.
  const auto found = std::lower_bound(crossings.begin(), crossings.end(), edges);
  if (found == crossings.end() || *found != edges) {
    throw std::logic_error("Two walks do not cross in the same edges.");
  }
  return first_crossing + static_cast<int>(found - crossings.begin());
}

MergedPoints merged_points(const std::array<const DiscMap*, 2>& maps,
                           const std::array<EdgeTraces, 2>& traces) {
  MergedPoints merged;
  int next = 0;
  for (std::size_t i = 0; i < traces[0].locations.size(); ++i) merged.numbers[0].push_back(next++);
  for (const Location& at : traces[1].locations) {
    const bool is_shared = at.within == Within::kPoint;
    merged.numbers[1].push_back(is_shared ? merged.numbers[0][at.index] : next++);
    if (is_shared) ++merged.shared_count;
  }
  merged.first_crossing = next;
  find_crossings(maps, traces[1], merged.crossings);
  return merged;
}

MergedPositions merged_positions(const std::array<const DiscMap*, 2>& maps,
                                 const CommonBorder& border,
                                 const std::array<EdgeTraces, 2>& traces,
                                 const MergedPoints& merged) {
  MergedPositions positions;
  positions.places.resize(merged.count());
  for (auto& points : positions.points) points.resize(merged.count());
  const std::array<PlacedDisc, 2> discs{PlacedDisc(*maps[0], border.places[0]),
                                        PlacedDisc(*maps[1], border.places[1])};
  for (int disc = 0; disc < 2; ++disc) {
    for (std::size_t i = 0; i < traces[disc].locations.size(); ++i) {
      const int number = merged.numbers[disc][i];
      const Vector2d& place = border.places[disc][i];
      // Points of both discs are written twice, the same each time.
      positions.places[number] = place;
      positions.points[disc][number] = maps[disc]->disc().points()[i];
      positions.points[1 - disc][number] =
          discs[1 - disc].point_at(traces[disc].locations[i], place);
    }
  }
  for (std::size_t i = 0; i < merged.crossings.size(); ++i) {
    const int number = merged.first_crossing + static_cast<int>(i);
    const MappedEdge first = discs[0].edge(merged.crossings[i][0]);
    const MappedEdge second = discs[1].edge(merged.crossings[i][1]);
    const double s = crossing_along(first, second), t = crossing_along(second, first);
    positions.points[0][number] = first.points[0] + s * (first.points[1] - first.points[0]);
    positions.points[1][number] = second.points[0] + t * (second.points[1] - second.points[0]);
    // The mean of both, so that the order of the discs does not matter.
    positions.places[number] =
        0.5 * ((first.places[0] + s * (first.places[1] - first.places[0])) +
               (second.places[0] + t * (second.places[1] - second.places[0])));
  }
  return positions;
}

}  // namespace hull::morphing

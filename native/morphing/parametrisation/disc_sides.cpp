// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/disc_sides.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hull::morphing {
namespace {

// Ten times what is one place where borders are merged.
constexpr double kLeastBorderEdge = 1e-8;  // of its side

// Where each corner is along the border, as an index of disc.border().
std::vector<int> corner_places(const TriangleDisc& disc, const std::vector<int>& corners) {
  const mesh::Topology& t = disc.topology();
  if (corners.size() < 3) {
    throw std::invalid_argument("The border has " + std::to_string(corners.size()) +
                                " corners: name three of its points or more.");
  }
  std::vector<int> place(t.vertex_count(), -1);
  const int count = static_cast<int>(disc.border().size());
  for (int i = 0; i < count; ++i) place[t.origin(disc.border()[i])] = i;
  std::vector<int> places;
  int last = -1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int point = corners[k];
    const std::string name = "Corner " + std::to_string(k) + ", point " + std::to_string(point);
    if (point < 0 || point >= t.vertex_count() || place[point] < 0) {
      throw std::invalid_argument(name + ", is not on the border: name a point that is.");
    }
    places.push_back(place[point]);
    // Along the border from the first corner on corners come in rising order, all within once
    // around.
    const int from_first = (places.back() - places.front() + count) % count;
    if (from_first <= last) {
      throw std::invalid_argument(name +
                                  ", comes too late: name corners once each, in the order of the "
                                  "border with the surface to its left.");
    }
    last = from_first;
  }
  return places;
}

// Half-edges along each side.
std::vector<std::vector<int>> sides_of(const TriangleDisc& disc, const std::vector<int>& corners) {
  const std::vector<int> places = corner_places(disc, corners);
  const int count = static_cast<int>(disc.border().size());
  std::vector<std::vector<int>> sides(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    // The last side ends at the first corner.
    const int end = places[(k + 1) % places.size()];
    for (int i = places[k]; i != end; i = (i + 1) % count) sides[k].push_back(disc.border()[i]);
  }
  return sides;
}

double edge_length(const TriangleDisc& disc, int h) {
  const mesh::Topology& t = disc.topology();
  return (disc.points()[t.origin(t.next(h))] - disc.points()[t.origin(h)]).norm();
}

double length_of(const TriangleDisc& disc, const std::vector<int>& side) {
  double length = 0.0;
  for (int h : side) length += edge_length(disc, h);
  return length;
}

// Of each point the side that begins there or has it within it, or -1; a corner ends another one.
bool on_one_side(const std::vector<int>& side_of, const std::vector<char>& is_corner, int sides,
                 int a, int b) {
  // Inner points are on no side.
  const int s = side_of[a], u = side_of[b];
  if (s < 0 || u < 0) return false;
  return s == u || (is_corner[b] && u == (s + 1) % sides) || (is_corner[a] && s == (u + 1) % sides);
}

// One triangle with what became of its edges: the new point on each, or -1.
void add_parts(const Triangle& corners, const std::array<int, 3>& middles,
               std::vector<Triangle>& parts) {
  const int count = static_cast<int>(
      std::count_if(middles.begin(), middles.end(), [](int middle) { return middle >= 0; }));
  const auto corner = [&](int i) { return corners[i % 3]; };
  const auto middle = [&](int i) { return middles[i % 3]; };
  if (count == 0) {
    parts.push_back(corners);
  } else if (count == 3) {
    // Middle i is on the edge from corner i to the next.
    parts.push_back({middles[0], middles[1], middles[2]});
    for (int i = 0; i < 3; ++i) parts.push_back({corner(i), middle(i), middle(i + 2)});
  } else if (count == 1) {
    int i = 0;
    while (middles[i] < 0) ++i;
    parts.push_back({corner(i), middle(i), corner(i + 2)});
    parts.push_back({middle(i), corner(i + 1), corner(i + 2)});
  } else {
    int i = 0;  // the edge that is whole
    while (middles[i] >= 0) ++i;
    // The corner between both halved edges, and a quad, which is cut in two.
    parts.push_back({middle(i + 1), corner(i + 2), middle(i + 2)});
    parts.push_back({corner(i), corner(i + 1), middle(i + 1)});
    parts.push_back({corner(i), middle(i + 1), middle(i + 2)});
  }
}

}  // namespace

std::vector<BorderPoint> border_points(const TriangleDisc& disc, const std::vector<int>& corners) {
  const mesh::Topology& t = disc.topology();
  const std::vector<std::vector<int>> sides = sides_of(disc, corners);
  std::vector<BorderPoint> points;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const double whole = length_of(disc, sides[k]);
    double before = 0.0;
    for (int h : sides[k]) {
      // A corner is of the side that begins there.
      points.push_back({t.origin(h), h, static_cast<int>(k), before / whole});
      const double length = edge_length(disc, h);
      if (length < kLeastBorderEdge * whole) {
        throw std::invalid_argument("Border edge " + std::to_string(t.origin(h)) + "–" +
                                    std::to_string(t.origin(t.next(h))) +
                                    " has less than 1e-8 of the length of its side: make its two "
                                    "points one.");
      }
      before += length;
    }
  }
  return points;
}

std::vector<double> side_lengths(const TriangleDisc& disc, const std::vector<int>& corners) {
  std::vector<double> lengths;
  for (const std::vector<int>& side : sides_of(disc, corners)) {
    lengths.push_back(length_of(disc, side));
  }
  return lengths;
}

SplitDisc split_chords(const TriangleDisc& disc, const std::vector<int>& corners) {
  const mesh::Topology& t = disc.topology();
  std::vector<int> side_of(t.vertex_count(), -1);
  std::vector<char> is_corner(t.vertex_count(), 0);
  for (const BorderPoint& at : border_points(disc, corners)) side_of[at.point] = at.side;
  for (int corner : corners) is_corner[corner] = 1;
  SplitDisc split{disc, {}};
  std::vector<Vector3d> points = disc.points();
  std::vector<int> middle(t.edge_count(), -1);
  // Once is enough: new points are inside, and no edge to one joins two points of a side.
  for (int h = 0; h < t.half_edge_count(); ++h) {
    if (t.twin(h) < 0 || !t.is_edge_front(h)) continue;
    const int a = t.origin(h), b = t.origin(t.next(h));
    if (!on_one_side(side_of, is_corner, static_cast<int>(corners.size()), a, b)) continue;
    // By edges: both triangles of one have the same point.
    middle[t.edge(h)] = static_cast<int>(points.size());
    points.push_back(0.5 * (disc.points()[a] + disc.points()[b]));
    split.split_edges.push_back({a, b});
  }
  if (split.split_edges.empty()) return split;
  std::vector<Triangle> triangles;
  for (int f = 0; f < t.face_count(); ++f) {
    const std::array<int, 3> middles{middle[t.edge(3 * f)], middle[t.edge(3 * f + 1)],
                                     middle[t.edge(3 * f + 2)]};
    add_parts(disc.triangle(f), middles, triangles);
  }
  split.disc = TriangleDisc(std::move(points), triangles);
  return split;
}

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/common_border.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hull::morphing {
namespace {

constexpr double kSamePlace = 1e-9;  // of the side; border edges are ten times as long at least

// Less than 0 where `a` comes first, 0 where both are one.
int order_of(const BorderPoint& a, const BorderPoint& b) {
  // Corners are points of both discs, and so no side's last point is one with the next one's first.
  if (a.side != b.side) return a.side < b.side ? -1 : 1;
  if (std::abs(a.along - b.along) < kSamePlace) return 0;
  return a.along < b.along ? -1 : 1;
}

void add_both(const DiscMap& first, const BorderPoint& a, const BorderPoint& b,
              CommonBorder& border) {
  border.points.push_back({{a.point, b.point}, {a.half_edge, b.half_edge}});
  // By length, not by disc: the order of the discs does not matter.
  const BorderPoint& earlier = a.along <= b.along ? a : b;
  const Vector2d place = first.polygon().on_side(earlier.side, earlier.along);
  border.places[0][a.point] = border.places[1][b.point] = place;
}

void check_triangle(const DiscMap& map, int disc, int t, const std::array<Vector2d, 3>& places) {
  if (orientation(places[0], places[1], places[2]) > 0.0) return;
  const auto [a, b, c] = map.disc().triangle(t);
  throw std::invalid_argument("The triangle of points " + std::to_string(a) + ", " +
                              std::to_string(b) + " and " + std::to_string(c) + " of the " +
                              (disc == 0 ? "first" : "second") +
                              " disc is too thin in the plane to be merged: name other corners, "
                              "or cut the surface into more parts.");
}

// REQUIRES: the border is complete.
void check_disc(const DiscMap& map, int disc, const CommonBorder& border) {
  const std::vector<Vector2d>& places = border.places[disc];
  for (int t = 0; t < map.disc().triangle_count(); ++t) {
    const auto [a, b, c] = map.disc().triangle(t);
    check_triangle(map, disc, t, {places[a], places[b], places[c]});
  }
  const mesh::Topology& topology = map.disc().topology();
  const int count = static_cast<int>(border.points.size());
  const auto place_of = [&](const CommonBorderPoint& at) {
    return at.points[0] >= 0 ? border.places[0][at.points[0]] : border.places[1][at.points[1]];
  };
  for (int i = 0; i < count; ++i) {
    // Once more with each piece of the chain in place of the triangle's own border edge, beside
    // which the chain may run by rounding.
    const int h = border.points[i].half_edges[disc];
    check_triangle(map, disc, topology.face(h),
                   {place_of(border.points[i]), place_of(border.points[(i + 1) % count]),
                    places[topology.origin(topology.prev(h))]});
  }
}

}  // namespace

CommonBorder common_border(const DiscMap& first, const DiscMap& second) {
  if (first.polygon().corners() != second.polygon().corners()) {
    throw std::invalid_argument("The two discs are mapped onto different polygons: take the same.");
  }
  // Merged as sorted lists are. Both begin with the first corner, so that there is always a point
  // before, on whose edge one of the other disc alone lies.
  CommonBorder border{{}, {first.places(), second.places()}};
  auto a = first.border().begin();
  auto b = second.border().begin();
  const auto end_a = first.border().end(), end_b = second.border().end();
  while (a != end_a || b != end_b) {
    const int order = a == end_a ? 1 : b == end_b ? -1 : order_of(*a, *b);
    if (order == 0) {
      add_both(first, *a++, *b++, border);
    } else if (order < 0) {
      border.points.push_back({{a->point, -1}, {a->half_edge, (b - 1)->half_edge}});
      ++a;
    } else {
      border.points.push_back({{-1, b->point}, {(a - 1)->half_edge, b->half_edge}});
      ++b;
    }
  }
  check_disc(first, 0, border);
  check_disc(second, 1, border);
  return border;
}

}  // namespace hull::morphing

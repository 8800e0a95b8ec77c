// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/edge_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "morphing/plane_grid.h"

namespace hull::morphing {
namespace {

constexpr int kSize = 5;

using Spot = std::array<long, 2>;

// Of coordinates that are whole numbers.
long turn(const Spot& a, const Spot& b, const Spot& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

long sign(long value) { return (value > 0) - (value < 0); }

// Walks over a grid whose coordinates are multiplied by 4, so that places between points are whole
// numbers, too.
class EdgeWalk : public testing::Test {
 protected:
  EdgeWalk() : disc_(plane_grid(kSize)) {
    for (const Vector3d& p : disc_.points()) {
      places_.emplace_back(4.0 * p.x(), 4.0 * p.y());
      spots_.push_back({std::lround(4.0 * p.x()), std::lround(4.0 * p.y())});
    }
  }

  const mesh::Topology& topology() const { return disc_.topology(); }
  Spot from(int h) const { return spots_[topology().origin(h)]; }
  Spot to(int h) const { return spots_[topology().origin(topology().next(h))]; }

  // By going through all points, edges and triangles.
  Location locate(const Spot& p) const {
    for (int v = 0; v < topology().vertex_count(); ++v) {
      if (spots_[v] == p) return {Within::kPoint, v};
    }
    for (int h = 0; h < topology().half_edge_count(); ++h) {
      const bool between = std::min(from(h), to(h)) < p && p < std::max(from(h), to(h));
      if (turn(from(h), to(h), p) == 0 && between) return {Within::kEdge, h};
    }
    for (int t = 0; t < topology().face_count(); ++t) {
      if (turns_in(t, p) == 3) return {Within::kTriangle, t};
    }
    ADD_FAILURE();
    return {Within::kPoint, -1};
  }

  // The edges of a triangle that a place is strictly inside of.
  int turns_in(int t, const Spot& p) const {
    int inside = 0;
    for (int h = 3 * t; h < 3 * t + 3; ++h) inside += turn(from(h), to(h), p) > 0;
    return inside;
  }

  bool same(const Location& a, const Location& b) const {
    const bool edges = a.within == Within::kEdge && b.within == Within::kEdge;
    return a.within == b.within &&
           (edges ? topology().edge(a.index) == topology().edge(b.index) : a.index == b.index);
  }

  bool is_on_border(const Spot& p) const {
    const long end = 4 * kSize;
    return p[0] == 0 || p[1] == 0 || p[0] == end || p[1] == end;
  }

  // Points strictly between the ends, and edges that are crossed there with both of their ends
  // beside the line, each as a pair of kind and number.
  std::set<std::pair<int, int>> expected_meetings(const Spot& p, const Spot& q) const {
    std::set<std::pair<int, int>> meetings;
    for (int v = 0; v < topology().vertex_count(); ++v) {
      const bool between = std::min(p, q) < spots_[v] && spots_[v] < std::max(p, q);
      if (turn(p, q, spots_[v]) == 0 && between) meetings.insert({0, v});
    }
    for (int h = 0; h < topology().half_edge_count(); ++h) {
      if (sign(turn(p, q, from(h))) * sign(turn(p, q, to(h))) < 0 &&
          sign(turn(from(h), to(h), p)) * sign(turn(from(h), to(h), q)) < 0) {
        meetings.insert({1, topology().edge(h)});
      }
    }
    return meetings;
  }

  void check(const Spot& p, const Spot& q) const {
    SCOPED_TRACE(testing::Message() << p[0] << "," << p[1] << " to " << q[0] << "," << q[1]);
    const Location end = locate(q);
    std::vector<Stretch> way;
    walk({&topology(), &places_}, locate(p), Vector2d(p[0], p[1]), Vector2d(q[0], q[1]),
         is_on_border(q) ? &end : nullptr, way);
    ASSERT_FALSE(way.empty());
    EXPECT_TRUE(same(way.back().end, end));
    std::set<std::pair<int, int>> meetings;
    for (std::size_t i = 0; i < way.size(); ++i) {
      EXPECT_EQ(way[i].triangle < 0, way[i].half_edge >= 0);
      if (i + 1 == way.size()) break;
      const Location& at = way[i].end;
      ASSERT_NE(at.within, Within::kTriangle);
      const bool is_new = at.within == Within::kPoint
                              ? meetings.insert({0, at.index}).second
                              : meetings.insert({1, topology().edge(at.index)}).second;
      EXPECT_TRUE(is_new);
    }
    EXPECT_EQ(meetings, expected_meetings(p, q));
    check_stretches(p, q, way);
  }

  // Each goes on to the left of the edges by which it may not leave, or along its half-edge.
  void check_stretches(const Spot& p, const Spot& q, const std::vector<Stretch>& way) const {
    for (const Stretch& stretch : way) {
      if (stretch.half_edge >= 0) {
        EXPECT_EQ(turn(p, q, from(stretch.half_edge)), 0);
        EXPECT_EQ(turn(p, q, to(stretch.half_edge)), 0);
        const Spot a = from(stretch.half_edge), b = to(stretch.half_edge);
        EXPECT_GT((b[0] - a[0]) * (q[0] - p[0]) + (b[1] - a[1]) * (q[1] - p[1]), 0);
        continue;
      }
      int left = 0, right = 0;
      for (int h = 3 * stretch.triangle; h < 3 * stretch.triangle + 3; ++h) {
        left += turn(p, q, from(h)) > 0;
        right += turn(p, q, from(h)) < 0;
      }
      EXPECT_TRUE(left > 0 && right > 0);
    }
  }

  TriangleDisc disc_;
  std::vector<Vector2d> places_;
  std::vector<Spot> spots_;
};

// From and to points, middles and quarters of edges, and places within triangles: all kinds of
// beginnings, ends and meetings, among them many lines through points and along edges.
TEST_F(EdgeWalk, MeetsWhatIsThere) {
  std::vector<Spot> all;
  for (long x = 0; x <= 4 * kSize; x += 2) {
    for (long y = 0; y <= 4 * kSize; y += 2) all.push_back({x, y});
  }
  all.push_back({5, 6});
  all.push_back({11, 13});
  all.push_back({7, 17});
  const long end = 4 * kSize;
  int walks = 0;
  for (const Spot& p : all) {
    for (const Spot& q : all) {
      const bool on_a_side = (p[0] == q[0] && (p[0] == 0 || p[0] == end)) ||
                             (p[1] == q[1] && (p[1] == 0 || p[1] == end));
      if (p == q || on_a_side) continue;
      check(p, q);
      ++walks;
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(walks, 10000);
}

}  // namespace
}  // namespace hull::morphing

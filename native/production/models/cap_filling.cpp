// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/cap_filling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "mesh/vectors.h"

namespace hull::production {
namespace {

using PlanePlaces = std::vector<Vector2d>;

double turn(const PlanePlaces& p, int a, int b, int c) { return cross(p[b] - p[a], p[c] - p[a]); }

// How far from `from` counter-clockwise to `to`, in (0, 2 pi].
double angle_between(const Vector2d& from, const Vector2d& to) {
  const double angle = std::atan2(cross(from, to), from.dot(to));
  return angle > 0.0 ? angle : angle + 2.0 * M_PI;
}

bool encloses(const PointLoop& loop, const PlanePlaces& places, const Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Vector2d &a = places[loop[i]], &b = places[loop[j]];
    // Corners at the ray's height count as below it, so that none is passed twice.
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

// Whether the way from corner i of a loop to a place sets out strictly inside the loop. Where
// several corners are at one point each has a part of the directions from there.
bool sets_out_inside(const PointLoop& loop, std::size_t i, const PlanePlaces& places,
                     const Vector2d& to) {
  const Vector2d& at = places[loop[i]];
  // The inside is what is passed from the next side counter-clockwise to the one before.
  const Vector2d next = places[loop[(i + 1) % loop.size()]] - at;
  const Vector2d before = places[loop[(i + loop.size() - 1) % loop.size()]] - at;
  return angle_between(next, to - at) < angle_between(next, before);
}

std::size_t rightmost(const PointLoop& loop, const PlanePlaces& places) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    if (places[loop[i]].x() > places[loop[best]].x()) best = i;
  }
  return best;
}

bool covers(const PlanePlaces& p, int a, int b, int c, const Vector2d& q) {
  return cross(p[b] - p[a], q - p[a]) >= 0.0 && cross(p[c] - p[b], q - p[b]) >= 0.0 &&
         cross(p[a] - p[c], q - p[c]) >= 0.0;
}

// The place in `outer` that a point to its left sees: the end of the side that is right of it, or a
// corner in between, the one nearest in direction.
std::size_t seen_from(const PointLoop& outer, const PlanePlaces& places, const Vector2d& m) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t found = outer.size();
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t j = (i + 1) % outer.size();
    const Vector2d &a = places[outer[i]], &b = places[outer[j]];
    // Sides have what is to be filled to their left; those to which holes were joined are there
    // twice, and only one way is seen from here.
    if (!(a.y() <= m.y() && m.y() < b.y())) continue;
    const double x = a.x() + (m.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
    if (x < m.x() || x >= nearest) continue;
    nearest = x;
    found = a.x() > b.x() ? i : j;
  }
  if (found == outer.size()) {  // nothing is right of it: the loops touch; any corner does
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const double distance = (places[outer[i]] - m).squaredNorm();
      if (distance < least) least = distance, found = i;
    }
    return found;
  }
  // Eberly 2008: corners in the triangle of m, the hit and the end may hide that end; of these the
  // one in the flattest direction, the nearest of several, is seen.
  const Vector2d hit(nearest, m.y()), end = places[outer[found]];
  const bool upward = end.y() > m.y();
  double least = std::numeric_limits<double>::infinity(), nearby = least;
  std::size_t best = found;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Vector2d& q = places[outer[i]];
    if (q == end || q.x() < m.x() || !sets_out_inside(outer, i, places, m)) continue;
    const Vector2d &p1 = upward ? hit : end, &p2 = upward ? end : hit;
    const bool inside = cross(p1 - m, q - m) >= 0.0 && cross(p2 - p1, q - p1) >= 0.0 &&
                        cross(m - p2, q - p2) >= 0.0;
    const double slope = std::abs(q.y() - m.y()) / std::max(q.x() - m.x(), 1e-300);
    const double way = (q - m).squaredNorm();
    if (inside && (slope < least || (slope == least && way < nearby))) {
      least = slope, nearby = way, best = i;
    }
  }
  return best;
}

// The loop with a hole joined to it along a line that is run through both ways.
void join_hole(PointLoop& outer, const PointLoop& hole, const PlanePlaces& places) {
  const std::size_t from = rightmost(hole, places);
  const std::size_t at = seen_from(outer, places, places[hole[from]]);
  PointLoop joined(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  // Its first corner comes twice, and so does the one of `outer`.
  for (std::size_t k = 0; k <= hole.size(); ++k) joined.push_back(hole[(from + k) % hole.size()]);
  joined.insert(joined.end(), outer.begin() + static_cast<std::ptrdiff_t>(at), outer.end());
  outer = std::move(joined);
}

// Cuts ears off one loop.
class EarCutter {
 public:
  EarCutter(PointLoop loop, const PlanePlaces& places) : loop_(std::move(loop)), places_(places) {}

  void cut(std::vector<std::array<int, 3>>& triangles) {
    std::size_t at = 0, failed = 0;
    // Without an ear in a whole round those that touch are taken, too; after another one any
    // corner.
    while (loop_.size() > 3) {
      at %= loop_.size();
      if (failed >= 2 * loop_.size()) {
        at = flattest();
      } else if (!is_ear(at, failed >= loop_.size())) {
        ++at, ++failed;
        continue;
      }
      failed = 0;
      triangles.push_back({before(at), loop_[at], after(at)});
      loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(at));
      ++at;  // not the neighbour, so that no fan arises
    }
    if (loop_.size() == 3) triangles.push_back({loop_[0], loop_[1], loop_[2]});
  }

 private:
  int before(std::size_t i) const { return loop_[(i + loop_.size() - 1) % loop_.size()]; }
  int after(std::size_t i) const { return loop_[(i + 1) % loop_.size()]; }

  // `touching`: the new side may lie on one that is there. Then that is one of four triangles,
  // unless there is no other way.
  bool is_ear(std::size_t i, bool touching) const {
    const int a = before(i), b = loop_[i], c = after(i);
    if (a == c || !(turn(places_, a, b, c) > 0.0)) return false;
    const std::size_t n = loop_.size();
    if (!touching && (!sets_out_inside(loop_, (i + n - 1) % n, places_, places_[c]) ||
                      !sets_out_inside(loop_, (i + 1) % n, places_, places_[a]))) {
      return false;
    }
    for (const int corner : loop_) {
      // Corners at the ear's own places are those that a joined hole has twice, or touch it.
      const Vector2d& q = places_[corner];
      if (q == places_[a] || q == places_[b] || q == places_[c]) continue;
      if (covers(places_, a, b, c, q)) return false;
    }
    return true;
  }

  // Where there is no ear the loop touches itself or has no area: the corner that takes the least.
  std::size_t flattest() const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const double area = std::abs(turn(places_, before(i), loop_[i], after(i)));
      if (before(i) != after(i) && area < least) least = area, best = i;
    }
    return best;
  }

  PointLoop loop_;
  const PlanePlaces& places_;
};

}  // namespace

std::vector<PointLoop> chained(const std::vector<std::pair<int, int>>& sides,
                               const PlanePlaces& places) {
  std::unordered_map<int, std::vector<int>> leaving;
  for (const auto& [from, to] : sides) leaving[from].push_back(to);
  const auto take = [&](int before, int at) {
    std::vector<int>& choices = leaving.at(at);
    std::size_t best = 0;
    if (before >= 0 && choices.size() > 1) {
      // The first choice clockwise from the way back is the one furthest to the left.
      const Vector2d back = places[before] - places[at];
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < choices.size(); ++k) {
        const double angle = angle_between(places[choices[k]] - places[at], back);
        if (angle < least) least = angle, best = k;
      }
    }
    const int next = choices[best];
    choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(best));
    return next;
  };
  std::vector<PointLoop> loops;
  for (const auto& [from, to] : sides) {
    while (!leaving.at(from).empty()) {
      PointLoop loop{from};
      int before = -1, at = from;
      for (int next = take(before, at); next != from; next = take(before, at)) {
        before = at, at = next;
        loop.push_back(at);
      }
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

double doubled_area(const PointLoop& loop, const PlanePlaces& places) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += turn(places, loop[0], loop[i], loop[i + 1]);
  }
  return sum;
}

std::vector<std::array<int, 3>> filled(const std::vector<PointLoop>& loops,
                                       const PlanePlaces& places) {
  std::vector<PointLoop> outer, holes;
  for (const PointLoop& loop : loops)
    (doubled_area(loop, places) < 0.0 ? holes : outer).push_back(loop);
  // Of the region that a hole is in the innermost one, which is the smallest.
  std::vector<std::vector<PointLoop>> within(outer.size());
  for (PointLoop& hole : holes) {
    const Vector2d& p = places[hole[rightmost(hole, places)]];
    double least = std::numeric_limits<double>::infinity();
    std::size_t owner = outer.size();
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const double area = doubled_area(outer[k], places);
      if (area < least && encloses(outer[k], places, p)) least = area, owner = k;
    }
    if (owner < outer.size()) {
      within[owner].push_back(std::move(hole));
    } else {
      outer.push_back(std::move(hole));  // in none: filled as what it is
      within.emplace_back();
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t k = 0; k < outer.size(); ++k) {
    // From the right: what a hole sees to its right is joined already.
    std::sort(within[k].begin(), within[k].end(), [&](const PointLoop& a, const PointLoop& b) {
      return places[a[rightmost(a, places)]].x() > places[b[rightmost(b, places)]].x();
    });
    for (const PointLoop& hole : within[k]) join_hole(outer[k], hole, places);
    EarCutter(std::move(outer[k]), places).cut(triangles);
  }
  return triangles;
}

}  // namespace hull::production

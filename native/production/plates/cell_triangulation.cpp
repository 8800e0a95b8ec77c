// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/cell_triangulation.h"

#include <cassert>
#include <cmath>
#include <stdexcept>

namespace hull::production {

CellTriangulation::CellTriangulation(const Vector2d& lengths)
    : lengths_(lengths / static_cast<double>(kParts)),
      points_{{0, 0}, {kParts, 0}, {kParts, kParts}, {0, kParts}},
      triangles_{{{0, 1, 2}, {-1, -1, 1}, {-1, -1, -1}}, {{0, 2, 3}, {0, -1, -1}, {-1, -1, -1}}} {}

// Twice the area of a triangle: exact, as coordinates are below 2^30.
std::int64_t CellTriangulation::turn(int a, int b, int c) const {
  const Grid &p = points_[a], &q = points_[b], &r = points_[c];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// Whether a-b and c-d cross in their insides.
bool CellTriangulation::is_crossed(int a, int b, int c, int d) const {
  const auto differ = [](std::int64_t x, std::int64_t y) {
    return (x > 0 && y < 0) || (x < 0 && y > 0);
  };
  return differ(turn(a, b, c), turn(a, b, d)) && differ(turn(c, d, a), turn(c, d, b));
}

CellTriangulation::Side CellTriangulation::twin(const Side& side) const {
  const Triangle& t = triangles_[side.triangle];
  const int beyond = t.beyond[side.edge];
  if (beyond < 0) return {-1, 0};
  for (int j = 0; j < 3; ++j) {
    if (triangles_[beyond].v[j] == t.v[(side.edge + 1) % 3]) return {beyond, j};
  }
  assert(false);
  return {-1, 0};
}

CellTriangulation::Side CellTriangulation::find(int a, int b) const {
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (triangles_[t].v[i] == a && triangles_[t].v[(i + 1) % 3] == b) return {t, i};
    }
  }
  return {-1, 0};
}

bool CellTriangulation::can_flip(const Side& side) const {
  if (triangles_[side.triangle].tag[side.edge] >= 0) return false;
  const Side other = twin(side);
  if (other.triangle < 0) return false;
  const auto& v = triangles_[side.triangle].v;
  const int a = v[side.edge], b = v[(side.edge + 1) % 3], c = v[(side.edge + 2) % 3];
  const int d = triangles_[other.triangle].v[(other.edge + 2) % 3];
  return turn(a, d, c) > 0 && turn(d, b, c) > 0;
}

// Delaunay's criterion by the angles opposite the edge: their sum exceeds π. Rounding only decides
// between triangles that are about equally good.
bool CellTriangulation::wants_flip(const Side& side) const {
  if (!can_flip(side)) return false;
  const Side other = twin(side);
  // In metres: in (u, v) alone a long cell's triangles would be slender on the hull.
  const auto at = [this](int p) {
    return Vector2d(static_cast<double>(points_[p][0]) * lengths_.x(),
                    static_cast<double>(points_[p][1]) * lengths_.y());
  };
  const auto& v = triangles_[side.triangle].v;
  const Vector2d a = at(v[side.edge]), b = at(v[(side.edge + 1) % 3]);
  const auto angle = [&](const Vector2d& p) {
    const Vector2d x = a - p, y = b - p;
    return std::atan2(std::abs(cross(x, y)), x.dot(y));
  };
  const double sum = angle(at(v[(side.edge + 2) % 3])) +
                     angle(at(triangles_[other.triangle].v[(other.edge + 2) % 3]));
  return sum > 3.14159265358979 + 1e-9;
}

// Makes `triangle` know what is beyond an edge, and that the other way round, where it was `from`.
void CellTriangulation::link(int triangle, int edge, int beyond, int from) {
  triangles_[triangle].beyond[edge] = beyond;
  if (beyond < 0) return;
  for (int j = 0; j < 3; ++j) {
    if (triangles_[beyond].beyond[j] == from &&
        triangles_[beyond].v[j] == triangles_[triangle].v[(edge + 1) % 3]) {
      triangles_[beyond].beyond[j] = triangle;
      return;
    }
  }
}

// REQUIRES: can_flip().
void CellTriangulation::flip(const Side& side) {
  const int t = side.triangle, i = side.edge;
  const Side other = twin(side);
  const int u = other.triangle, j = other.edge;
  const Triangle one = triangles_[t], two = triangles_[u];
  const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  const int a = one.v[i], b = one.v[i1], c = one.v[i2], d = two.v[j2];
  triangles_[t] = {{a, d, c}, {-1, u, -1}, {two.tag[j1], -1, one.tag[i2]}};
  triangles_[u] = {{d, b, c}, {-1, -1, t}, {two.tag[j2], one.tag[i1], -1}};
  link(t, 0, two.beyond[j1], u);
  link(t, 2, one.beyond[i2], t);
  link(u, 0, two.beyond[j2], u);
  link(u, 1, one.beyond[i1], t);
}

void CellTriangulation::split_triangle(int t, int p) {
  const Triangle old = triangles_[t];
  const int n = static_cast<int>(triangles_.size());
  const auto [a, b, c] = old.v;
  triangles_[t] = {{a, b, p}, {-1, n, n + 1}, {old.tag[0], -1, -1}};
  triangles_.push_back({{b, c, p}, {-1, n + 1, t}, {old.tag[1], -1, -1}});
  triangles_.push_back({{c, a, p}, {-1, t, n}, {old.tag[2], -1, -1}});
  link(t, 0, old.beyond[0], t);
  link(n, 0, old.beyond[1], t);
  link(n + 1, 0, old.beyond[2], t);
  legalise({{t, 0}, {n, 0}, {n + 1, 0}});
}

void CellTriangulation::split_side(const Side& side, int p) {
  const Side other = twin(side);
  const int t = side.triangle, i = side.edge, n = static_cast<int>(triangles_.size());
  const Triangle one = triangles_[t];
  const int a = one.v[i], b = one.v[(i + 1) % 3], c = one.v[(i + 2) % 3];
  const int tag = one.tag[i];
  const bool inner = other.triangle >= 0;
  const int u = other.triangle, m = n + 1;
  triangles_[t] = {{a, p, c}, {inner ? m : -1, n, -1}, {tag, -1, one.tag[(i + 2) % 3]}};
  triangles_.push_back({{p, b, c}, {inner ? u : -1, -1, t}, {tag, one.tag[(i + 1) % 3], -1}});
  link(t, 2, one.beyond[(i + 2) % 3], t);
  link(n, 1, one.beyond[(i + 1) % 3], t);
  std::vector<Side> changed{{t, 2}, {n, 1}};
  if (inner) {
    const Triangle two = triangles_[u];
    const int j = other.edge, d = two.v[(j + 2) % 3];
    triangles_[u] = {{b, p, d}, {n, m, -1}, {tag, -1, two.tag[(j + 2) % 3]}};
    triangles_.push_back({{p, a, d}, {t, -1, u}, {tag, two.tag[(j + 1) % 3], -1}});
    link(u, 2, two.beyond[(j + 2) % 3], u);
    link(m, 1, two.beyond[(j + 1) % 3], u);
    changed.push_back({u, 2});
    changed.push_back({m, 1});
  }
  legalise(std::move(changed));
}

void CellTriangulation::legalise(std::vector<Side> sides) {
  // Each flip makes the least angle larger, so that they end; the count is for what rounding does.
  std::size_t left = 50 * triangles_.size() + 1000;
  while (!sides.empty() && left > 0) {
    const Side side = sides.back();
    sides.pop_back();
    if (!wants_flip(side)) continue;
    --left;
    const int u = twin(side).triangle;
    flip(side);
    for (const Side& next : {Side{side.triangle, 0}, {side.triangle, 2}, {u, 0}, {u, 1}}) {
      sides.push_back(next);
    }
  }
}

int CellTriangulation::add(const Grid& at) {
  const int p = static_cast<int>(points_.size());
  points_.push_back(at);
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    const auto& v = triangles_[t].v;
    std::array<std::int64_t, 3> turns{};
    for (int i = 0; i < 3; ++i) turns[i] = turn(v[i], v[(i + 1) % 3], p);
    if (turns[0] < 0 || turns[1] < 0 || turns[2] < 0) continue;
    for (int i = 0; i < 3; ++i) {
      if (points_[v[i]] == at) {
        points_.pop_back();
        return v[i];
      }
    }
    for (int i = 0; i < 3; ++i) {
      if (turns[i] == 0) {
        split_side({t, i}, p);
        return p;
      }
    }
    split_triangle(t, p);
    return p;
  }
  throw std::logic_error("a point outside of its cell");
}

void CellTriangulation::mark(const Side& side, int tag) {
  int& own = triangles_[side.triangle].tag[side.edge];
  if (own < 0) own = tag;  // the first curve keeps it
  if (const Side other = twin(side); other.triangle >= 0) {
    triangles_[other.triangle].tag[other.edge] = own;
  }
}

// The next point on the way from a to b: b, or one that lies on it. `crossed` gets the edges
// between. Where these are tagged, `detour` is the end of the tagged edge that is nearer to the
// way.
int CellTriangulation::next_on_way(int a, int b, std::vector<std::array<int, 2>>& crossed,
                                   int& detour) const {
  const auto ahead = [&](int p) {
    const Grid &o = points_[a], &q = points_[p], &e = points_[b];
    return (q[0] - o[0]) * (e[0] - o[0]) + (q[1] - o[1]) * (e[1] - o[1]) > 0;
  };
  Side side{-1, 0};
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (triangles_[t].v[i] != a) continue;
      const int p = triangles_[t].v[(i + 1) % 3], q = triangles_[t].v[(i + 2) % 3];
      for (const int end : {p, q}) {
        if (end == b || (turn(a, b, end) == 0 && ahead(end))) return end;
      }
      if (turn(a, b, p) < 0 && turn(a, b, q) > 0) side = {t, (i + 1) % 3};  // between p and q
    }
  }
  assert(side.triangle >= 0);
  while (true) {
    const Triangle& t = triangles_[side.triangle];
    const int p = t.v[side.edge], q = t.v[(side.edge + 1) % 3];
    if (t.tag[side.edge] >= 0) {
      const auto off_p = -turn(a, b, p), off_q = turn(a, b, q);
      detour = off_p < off_q ? p : q;
      return b;
    }
    crossed.push_back({p, q});
    const Side beyond = twin(side);
    const int r = triangles_[beyond.triangle].v[(beyond.edge + 2) % 3];
    const std::int64_t side_of_r = turn(a, b, r);
    if (r == b || side_of_r == 0) return r;
    // Out of the next triangle by the side whose ends are on both sides of the way.
    side = {beyond.triangle, (beyond.edge + (side_of_r > 0 ? 1 : 2)) % 3};
  }
}

// Flips the edges that are crossed until a-b is one (Sloan 1993).
void CellTriangulation::clear_way(int a, int b, std::vector<std::array<int, 2>> crossed) {
  for (std::size_t k = 0, most = 100 * crossed.size() * (crossed.size() + 1); k < crossed.size();
       ++k) {
    if (k > most) throw std::logic_error("an edge of a cell can't be made");
    const auto [p, q] = crossed[k];
    const Side side = find(p, q);
    // Where the two triangles are no convex quadrilateral the edge comes again after the others.
    if (!can_flip(side)) {
      crossed.push_back({p, q});
      continue;
    }
    const int c = triangles_[side.triangle].v[(side.edge + 2) % 3];
    const Side other = twin(side);
    const int d = triangles_[other.triangle].v[(other.edge + 2) % 3];
    flip(side);
    if (is_crossed(a, b, c, d)) crossed.push_back({d, c});
  }
}

void CellTriangulation::constrain(int a, int b, int tag) {
  for (int steps = 0; a != b; ++steps) {
    if (steps > 10000) throw std::logic_error("an edge of a cell does not end");
    std::vector<std::array<int, 2>> crossed;
    int detour = -1;
    const int next = next_on_way(a, b, crossed, detour);
    if (detour >= 0) {
      constrain(a, detour, tag);
      a = detour;  // and on from there
      continue;
    }
    clear_way(a, next, std::move(crossed));
    Side side = find(a, next);
    if (side.triangle < 0) side = find(next, a);
    mark(side, tag);
    a = next;
  }
}

std::vector<std::array<int, 3>> CellTriangulation::triangles() {
  std::vector<Side> all;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    for (int i = 0; i < 3; ++i) all.push_back({t, i});
  }
  legalise(std::move(all));
  std::vector<std::array<int, 3>> corners;
  for (const Triangle& t : triangles_) corners.push_back(t.v);
  return corners;
}

std::vector<CellTriangulation::Edge> CellTriangulation::constraints() const {
  std::vector<Edge> edges;
  for (const Triangle& t : triangles_) {
    for (int i = 0; i < 3; ++i) {
      if (t.tag[i] >= 0) edges.push_back({t.v[i], t.v[(i + 1) % 3], t.tag[i]});
    }
  }
  return edges;
}

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/eigenbasis/subdivision_rules.h"

// Which control points a cell depends on, named by their role around it. Every function takes the
// cell's half-edge at the corner in question, on a mesh of quadrilaterals, and names points by a
// half-edge that starts there (numbers of vertices would not tell roles apart on tiny closed
// meshes). `T` is Topology or RefinedView.
namespace hull::surface {

// Grid coordinates (a, b): the corner is (0, 0), its half-edge runs to (1, 0), the cell's opposite
// corner is (1, 1).
//
// A point of the 4 x 4 grid that does not exist because the cell ends at a crease there.
inline constexpr int kNoPoint = -1;

// The corner's fan: the faces of its sector, or all of them where at most one crease edge meets it.
struct CornerFan {
  int first;    // the clockwise-most face's half-edge at the corner; the cell's own if closed
  int faces;    // how many
  int cell;     // position of the cell in it, counter-clockwise from first
  bool closed;  // first and last face share a smooth edge
  mesh::VertexKind kind;  // of the corner
};

template <class T>
CornerFan corner_fan(const T& t, int h) {
  CornerFan fan{h, t.sector_faces(h), 0, false, t.kind_at(h)};
  for (int right = mesh::turn_right(t, h); right >= 0; right = mesh::turn_right(t, right)) {
    if (right == h) {
      fan.first = h;
      fan.cell = 0;
      fan.closed = true;
      break;
    }
    fan.first = right;
    ++fan.cell;
  }
  return fan;
}

// Whether the surface near this corner of the cell is that of a uniform B-spline (modified edges
// apart).
template <class T>
bool is_regular_corner(const T& t, int h) {
  switch (t.kind_at(h)) {
    case mesh::VertexKind::kSmooth:
      return t.sector_faces(h) == 4;
    case mesh::VertexKind::kCrease:
      return t.sector_faces(h) == 2;
    case mesh::VertexKind::kCorner:
      return t.sector_faces(h) == 1;
    default:
      return false;
  }
}

// Whether a modified edge ends at this corner of the cell, which makes the cell not a polynomial
// although its points look regular (docs/surface.md, trap 2). Creases bound what is looked at.
template <class T>
bool touches_modified_edge(const T& t, Scheme scheme, int h) {
  if (scheme != Scheme::kBiermann || !is_smooth_at(t, h)) return false;
  int i = h;
  do {
    if (is_modified_edge(t, scheme, i)) return true;
    i = t.twin(t.prev(i));
  } while (i >= 0 && i != h);
  return false;
}

// Whether the cell of h is one bicubic polynomial of its 4 x 4 grid.
template <class T>
bool is_regular_cell(const T& t, Scheme scheme, int h) {
  int i = h;
  do {
    if (!is_regular_corner(t, i) || touches_modified_edge(t, scheme, i)) return false;
    i = t.next(i);
  } while (i != h);
  return true;
}

// Points around the corner: itself, then for each face of the fan the end of its first edge and its
// opposite corner, and the end of the last edge unless that is the first again. The limit near the
// corner depends on these alone, and so do their successors after a subdivision.
template <class T>
std::vector<int> ring_points(const T& t, const CornerFan& fan) {
  std::vector<int> points;
  points.reserve(2 * fan.faces + 2);
  points.push_back(fan.first);
  int i = fan.first;
  for (int k = 0; k < fan.faces; ++k) {
    points.push_back(t.next(i));
    points.push_back(t.next(t.next(i)));
    const int left = t.twin(t.prev(i));
    if (k + 1 == fan.faces && left != fan.first) points.push_back(t.prev(i));
    i = left;
  }
  return points;
}

// The points of the grid with a = 2 or b = 2, in the order (2,-1) (2,0) (2,1) (2,2) (1,2) (0,2)
// (-1,2); the first and last are left out where the cell ends at a crease. REQUIRES: the corners
// (1, 0), (1, 1), (0, 1) are regular.
template <class T>
std::vector<int> outer_points(const T& t, int h) {
  std::vector<int> points;
  points.reserve(7);
  const int right = t.twin(t.next(h));          // (1,1) -> (1,0), in the cell to the right
  const int far_right = t.next(t.next(right));  // (2,0) -> (2,1)
  if (!t.is_crease(h)) points.push_back(t.prev(t.twin(t.next(right))));
  points.push_back(far_right);
  points.push_back(t.next(far_right));
  const int diagonal = t.twin(t.prev(right));  // (1,1) -> (2,1)
  points.push_back(t.next(t.next(diagonal)));
  points.push_back(t.prev(diagonal));
  const int top = t.twin(t.next(t.next(h)));  // (0,1) -> (1,1), in the cell above
  points.push_back(t.prev(top));
  if (!t.is_crease(t.prev(h))) {
    const int left = t.twin(t.prev(top));  // (0,1) -> (0,2), in the cell to the left of that
    points.push_back(t.next(t.next(left)));
  }
  return points;
}

// The 4 x 4 grid of a regular cell, index 4 (b + 1) + (a + 1); kNoPoint beyond creases.
template <class T>
std::array<int, 16> grid_points(const T& t, int h) {
  std::array<int, 16> grid;
  grid.fill(kNoPoint);
  // Grid index of (a, b) seen from corner k, the grid turned so that the corner is (0, 0).
  const auto at = [](int k, int a, int b) {
    for (; k > 0; --k) {
      const int turned = 1 - b;
      b = a;
      a = turned;
    }
    return 4 * (b + 1) + (a + 1);
  };
  int corner = h;
  for (int k = 0; k < 4; ++k, corner = t.next(corner)) {
    grid[at(k, 0, 0)] = corner;
    if (t.is_crease(corner)) continue;
    const int below = t.twin(corner);       // (1,0) -> (0,0), in the cell below
    const int end = t.next(t.next(below));  // (0,-1) -> (1,-1)
    grid[at(k, 0, -1)] = end;
    grid[at(k, 1, -1)] = t.next(end);
    if (t.is_crease(t.prev(corner))) continue;
    const int diagonal = t.twin(t.next(below));  // (0,-1) -> (0,0), in the cell below left
    grid[at(k, -1, -1)] = t.prev(diagonal);
  }
  return grid;
}

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/border_edges.h"

namespace hull::analysis {
namespace {

Vector3d on_side(const surface::LimitSurface& surface, int half_edge, double t) {
  const int cell = half_edge / 4;
  switch (half_edge % 4) {
    case 0:
      return surface.position(cell, t, 0.0);
    case 1:
      return surface.position(cell, 1.0, t);
    case 2:
      return surface.position(cell, 1.0 - t, 1.0);
    default:
      return surface.position(cell, 0.0, 1.0 - t);
  }
}

// A border is a uniform cubic B-spline of its own control points, also beside irregular points:
// four of an edge's points tell the cubic.
std::array<Vector3d, 4> cubic_of(const surface::LimitSurface& surface, int half_edge) {
  const Vector3d p0 = on_side(surface, half_edge, 0.0), p3 = on_side(surface, half_edge, 1.0);
  const Vector3d a = on_side(surface, half_edge, 1.0 / 3.0);
  const Vector3d b = on_side(surface, half_edge, 2.0 / 3.0);
  return {p0, (-5.0 * p0 + 18.0 * a - 9.0 * b + 2.0 * p3) / 6.0,
          (2.0 * p0 - 9.0 * a + 18.0 * b - 5.0 * p3) / 6.0, p3};
}

int next_along_border(const mesh::Topology& cells, int half_edge) {
  // Clockwise around the side's end, across all cells there.
  int h = cells.next(half_edge);
  while (cells.twin(h) >= 0) h = cells.next(cells.twin(h));
  return h;
}

}  // namespace

std::array<double, 4> BorderEdge::along(const Vector3d& direction, double offset) const {
  return {direction.dot(points[0]) - offset, direction.dot(points[1]) - offset,
          direction.dot(points[2]) - offset, direction.dot(points[3]) - offset};
}

std::vector<BorderEdge> border_edges(const surface::LimitSurface& surface) {
  const mesh::Topology& cells = surface.cells();
  std::vector<BorderEdge> edges;
  std::vector<char> used(cells.half_edge_count(), 0);
  int loop = 0;
  for (int first = 0; first < cells.half_edge_count(); ++first) {
    if (cells.twin(first) >= 0 || used[first]) continue;
    // Each border is closed: the walk ends at its own beginning.
    for (int h = first; !used[h]; h = next_along_border(cells, h)) {
      used[h] = 1;
      edges.push_back({h, loop, cubic_of(surface, h)});
    }
    ++loop;
  }
  return edges;
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/grid_points.h"

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace hull::production {

GridPoints::GridPoints(const mesh::Topology& cells, const surface::CellDivisions& divisions)
    : cells_(cells), divisions_(divisions) {
  // Counted in 64 bits. Numbers of vertices come first, then those of the insides of edges, then
  // those of the insides of cells.
  std::int64_t next = 0;
  const auto take = [&next](std::int64_t more) {
    const std::int64_t first = next;
    next += more;
    if (next > std::numeric_limits<int>::max()) {
      throw std::invalid_argument("There would be more than 2^31 points; ask for larger parts.");
    }
    return static_cast<int>(first);
  };
  vertices_.assign(cells.vertex_count(), -1);
  for (int v = 0; v < cells.vertex_count(); ++v) {
    // Isolated control points are no part of the surface.
    if (cells.outgoing(v) >= 0) vertices_[v] = take(1);
  }
  edges_.assign(cells.edge_count(), -1);
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    if (cells.is_edge_front(h)) edges_[cells.edge(h)] = take(divisions.side(h) - 1);
  }
  for (int cell = 0; cell < cells.face_count(); ++cell) {
    cells_first_.push_back(take((divisions.u(cell) - std::int64_t{1}) * (divisions.v(cell) - 1)));
  }
  count_ = static_cast<int>(next);
}

int GridPoints::at(int cell, int i, int j) const {
  // Half-edge h + k is side k of the cell, and runs around it: sides 2 and 3 come back against u
  // and v.
  const int h = 4 * cell, nu = divisions_.u(cell), nv = divisions_.v(cell);
  if (j == 0) return on_side(h, i);
  if (i == nu) return on_side(h + 1, j);
  if (j == nv) return on_side(h + 2, nu - i);
  if (i == 0) return on_side(h + 3, nv - j);
  return cells_first_[cell] + (j - 1) * (nu - 1) + i - 1;
}

int GridPoints::on_side(int h, int k) const {
  const int n = divisions_.side(h);
  if (k == 0) return vertices_[cells_.origin(h)];
  if (k == n) return vertices_[cells_.origin(cells_.next(h))];
  // An edge's points are numbered along its front half-edge.
  return edges_[cells_.edge(h)] + (cells_.is_edge_front(h) ? k : n - k) - 1;
}

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/tessellation.h"

#include <stdexcept>
#include <string>

namespace hull {
namespace {

// Numbers the points: first the vertices of Q¹, then n - 1 on each of its edges, then
// (n - 1)^2 within each cell.
class Numbering {
 public:
  Numbering(const Topology& cells, int n) : cells_(cells), n_(n) {}

  int count() const {
    return cells_.vertex_count() + cells_.edge_count() * (n_ - 1) +
           cells_.face_count() * (n_ - 1) * (n_ - 1);
  }

  int at(int cell, int i, int j) const {
    const int h = 4 * cell;
    if (j == 0) return on_side(h, i);
    if (i == n_) return on_side(h + 1, j);
    if (j == n_) return on_side(h + 2, n_ - i);
    if (i == 0) return on_side(h + 3, n_ - j);
    return cells_.vertex_count() + cells_.edge_count() * (n_ - 1) +
           (cell * (n_ - 1) + j - 1) * (n_ - 1) + i - 1;
  }

 private:
  int on_side(int h, int i) const {
    if (i == 0) return cells_.origin(h);
    if (i == n_) return cells_.origin(cells_.next(h));
    const int along = cells_.is_edge_front(h) ? i : n_ - i;
    return cells_.vertex_count() + cells_.edge(h) * (n_ - 1) + along - 1;
  }

  const Topology& cells_;
  int n_;
};

}  // namespace

Tessellation tessellate(const LimitSurface& surface, int n) {
  if (n < 1 || n > 256) {
    throw std::invalid_argument("Cells can be divided into 1 to 256 parts a side, not " +
                                std::to_string(n) + ".");
  }
  const Numbering numbering(surface.cells(), n);
  Tessellation result;
  result.points.resize(numbering.count());
  result.cells.assign(numbering.count(), -1);
  result.uv.resize(numbering.count());
  std::vector<Vector3d> normals((n + 1) * (n + 1));
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        normals[j * (n + 1) + i] = surface.normal(cell, u, v);
        const int point = numbering.at(cell, i, j);
        if (result.cells[point] >= 0) continue;
        result.points[point] = surface.position(cell, u, v);
        result.cells[point] = cell;
        result.uv[point] = {u, v};
      }
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        result.quads.push_back({numbering.at(cell, i, j), numbering.at(cell, i + 1, j),
                                numbering.at(cell, i + 1, j + 1), numbering.at(cell, i, j + 1)});
        const Vector3d* row = &normals[j * (n + 1) + i];
        result.corner_normals.push_back({row[0], row[1], row[n + 2], row[n + 1]});
      }
    }
  }
  return result;
}

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/tessellation.h"

#include "surface/grid_samples.h"

namespace hull {
namespace {

// Numbers the points: first the vertices of Q¹, then n - 1 on each of its edges, then
// (n - 1)^2 within each cell.
class Numbering {
 public:
  Numbering(const Topology& cells, int n) : cells_(cells), n_(n) {
    vertices_.reserve(cells.vertex_count());
    // Isolated control points are no part of the surface.
    for (int v = 0; v < cells.vertex_count(); ++v) {
      vertices_.push_back(cells.outgoing(v) < 0 ? -1 : vertex_count_++);
    }
  }

  int count() const {
    return vertex_count_ + cells_.edge_count() * (n_ - 1) +
           cells_.face_count() * (n_ - 1) * (n_ - 1);
  }

  int at(int cell, int i, int j) const {
    const int h = 4 * cell;
    if (j == 0) return on_side(h, i);
    if (i == n_) return on_side(h + 1, j);
    if (j == n_) return on_side(h + 2, n_ - i);
    if (i == 0) return on_side(h + 3, n_ - j);
    return vertex_count_ + cells_.edge_count() * (n_ - 1) + (cell * (n_ - 1) + j - 1) * (n_ - 1) +
           i - 1;
  }

 private:
  int on_side(int h, int i) const {
    if (i == 0) return vertices_[cells_.origin(h)];
    if (i == n_) return vertices_[cells_.origin(cells_.next(h))];
    const int along = cells_.is_edge_front(h) ? i : n_ - i;
    return vertex_count_ + cells_.edge(h) * (n_ - 1) + along - 1;
  }

  const Topology& cells_;
  int n_;
  int vertex_count_ = 0;
  std::vector<int> vertices_;
};

}  // namespace

Tessellation tessellate(const LimitSurface& surface, int n) {
  const GridSamples samples = evaluate_grid(surface, n, 1);
  const Numbering numbering(surface.cells(), n);
  Tessellation result;
  result.points.resize(numbering.count());
  result.cells.assign(numbering.count(), -1);
  result.uv.resize(numbering.count());
  std::vector<Vector3d> normals((n + 1) * (n + 1));
  result.quads.reserve(static_cast<std::size_t>(surface.cell_count()) * n * n);
  result.corner_normals.reserve(result.quads.capacity());
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const std::size_t sample = samples.index(cell, i, j);
        const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
        Vector3d& normal = normals[j * (n + 1) + i];
        normal = unit_normal(samples.du[sample], samples.dv[sample]);
        // Derivatives vanish at irregular knots, where the tangent plane is had otherwise.
        if (normal.isZero(0.0)) normal = surface.normal(cell, u, v);
        const int point = numbering.at(cell, i, j);
        if (result.cells[point] >= 0) continue;
        result.points[point] = samples.points[sample];
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

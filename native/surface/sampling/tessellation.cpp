// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/tessellation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "surface/sampling/chord_divisions.h"
#include "surface/sampling/grid_samples.h"

namespace hull::surface {
namespace {

// Numbers points or normals: first those at vertices of Q¹, then those on its edges, then those
// within each cell. Normals are numbered apart on both sides of a crease.
class Numbering {
 public:
  Numbering(const mesh::Topology& cells, const CellDivisions& divisions, bool split_at_creases)
      : cells_(cells), divisions_(divisions) {
    if (split_at_creases) {
      number_sectors();
    } else {
      number_vertices();
    }
    number_edges(split_at_creases);
    within_.reserve(cells.face_count());
    for (int cell = 0; cell < cells.face_count(); ++cell) {
      within_.push_back(take((divisions.u(cell) - std::int64_t{1}) * (divisions.v(cell) - 1)));
    }
  }

  int count() const { return static_cast<int>(count_); }

  int at(int cell, int i, int j) const {
    const int h = 4 * cell, nu = divisions_.u(cell), nv = divisions_.v(cell);
    // Sides first: their points belong to edges, whichever cell asks.
    if (j == 0) return on_side(h, i, nu);
    if (i == nu) return on_side(h + 1, j, nv);
    if (j == nv) return on_side(h + 2, nu - i, nu);
    if (i == 0) return on_side(h + 3, nv - j, nv);
    return within_[cell] + (j - 1) * (nu - 1) + i - 1;
  }

 private:
  // The first of `more` numbers.
  int take(std::int64_t more) {
    const std::int64_t first = count_;
    count_ += more;
    // Before anything of that size is made.
    if (count_ > std::numeric_limits<int>::max()) {
      throw std::invalid_argument(
          "The tessellation would have more than 2^31 points. Divide cells "
          "into fewer parts.");
    }
    return static_cast<int>(first);
  }

  void number_vertices() {
    std::vector<int> vertices(cells_.vertex_count(), -1);
    for (int v = 0; v < cells_.vertex_count(); ++v) {
      // Isolated control points are no part of the surface.
      if (cells_.outgoing(v) >= 0) vertices[v] = take(1);
    }
    corners_.reserve(cells_.half_edge_count());
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      corners_.push_back(vertices[cells_.origin(h)]);
    }
  }

  void number_sectors() {
    corners_.assign(cells_.half_edge_count(), -1);
    for (int start = 0; start < cells_.half_edge_count(); ++start) {
      if (corners_[start] >= 0) continue;
      // What is reached around the vertex without crossing a crease.
      const int sector = take(1);
      for (int h = start; h >= 0 && corners_[h] < 0; h = mesh::turn_left(cells_, h)) {
        corners_[h] = sector;
      }
      // The first half-edge may be in the middle of its sector.
      for (int h = mesh::turn_right(cells_, start); h >= 0 && corners_[h] < 0;
           h = mesh::turn_right(cells_, h)) {
        corners_[h] = sector;
      }
    }
  }

  void number_edges(bool split_at_creases) {
    std::vector<int> fronts(cells_.edge_count(), -1);
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      if (cells_.is_edge_front(h)) fronts[cells_.edge(h)] = h;
    }
    edges_.assign(cells_.half_edge_count(), -1);
    for (int h : fronts) {
      edges_[h] = take(divisions_.side(h) - 1);
      const int twin = cells_.twin(h);
      if (twin < 0) continue;
      const bool apart = split_at_creases && cells_.is_crease(h);
      edges_[twin] = apart ? take(divisions_.side(h) - 1) : edges_[h];
    }
  }

  int on_side(int h, int i, int n) const {
    if (i == 0) return corners_[h];
    if (i == n) return corners_[cells_.next(h)];
    // Numbers run along the edge's front half-edge; its twin runs against them.
    return edges_[h] + (cells_.is_edge_front(h) ? i : n - i) - 1;
  }

  const mesh::Topology& cells_;
  const CellDivisions& divisions_;
  std::int64_t count_ = 0;
  std::vector<int> corners_, edges_;  // by half-edge: of its origin, of the first within its edge
  std::vector<int> within_;           // by cell
};

class Builder {
 public:
  Builder(const LimitSurface& surface, const CellDivisions& divisions)
      : surface_(surface),
        divisions_(divisions),
        points_(surface.cells(), divisions, false),
        normals_(surface.cells(), divisions, true) {
    result_.points.resize(points_.count());
    result_.cells.assign(points_.count(), -1);
    result_.uv.resize(points_.count());
    result_.normals.resize(normals_.count());
    result_.normal_cells.resize(normals_.count());
    result_.normal_uv.resize(normals_.count());
    has_normal_.assign(normals_.count(), 0);
    const auto quads = static_cast<std::size_t>(divisions.quad_count());
    result_.quads.reserve(quads);
    result_.corner_normals.reserve(quads);
  }

  Tessellation build() {
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      const int nu = divisions_.u(cell), nv = divisions_.v(cell);
      evaluate_cell_grid(surface_, cell, nu, nv, 1, samples_);
      take_samples(cell, nu, nv);
      add_quads(nu, nv);
    }
    return std::move(result_);
  }

 private:
  void take_samples(int cell, int nu, int nv) {
    point_at_.clear();
    normal_at_.clear();
    for (int j = 0; j <= nv; ++j) {
      for (int i = 0; i <= nu; ++i) {
        // Samples run along v, numbers of corners along u.
        const std::size_t sample = static_cast<std::size_t>(i) * (nv + 1) + j;
        const double u = static_cast<double>(i) / nu, v = static_cast<double>(j) / nv;
        const int point = points_.at(cell, i, j), normal = normals_.at(cell, i, j);
        point_at_.push_back(point);
        normal_at_.push_back(normal);
        // The first cell gives it to all that share it.
        if (!has_normal_[normal]) {
          has_normal_[normal] = 1;
          Vector3d& value = result_.normals[normal];
          value = unit_normal(samples_.du[sample], samples_.dv[sample]);
          // Derivatives vanish at irregular knots, where the tangent plane is had otherwise.
          if (value.isZero(0.0)) value = surface_.normal(cell, u, v);
          result_.normal_cells[normal] = cell;
          result_.normal_uv[normal] = {u, v};
        }
        if (result_.cells[point] >= 0) continue;
        result_.points[point] = samples_.points[sample];
        result_.cells[point] = cell;
        result_.uv[point] = {u, v};
      }
    }
  }

  void add_quads(int nu, int nv) {
    for (int j = 0; j < nv; ++j) {
      for (int i = 0; i < nu; ++i) {
        const int low = j * (nu + 1) + i, high = low + nu + 1;
        const auto corners = [&](const std::vector<int>& at) {
          return std::array<int, 4>{at[low], at[low + 1], at[high + 1], at[high]};
        };
        result_.quads.push_back(corners(point_at_));
        result_.corner_normals.push_back(corners(normal_at_));
      }
    }
  }

  const LimitSurface& surface_;
  const CellDivisions& divisions_;
  Numbering points_, normals_;
  GridSamples samples_;                    // of one cell, as are …
  std::vector<int> point_at_, normal_at_;  // … the numbers of its samples, row after row along u
  std::vector<char> has_normal_;
  Tessellation result_;
};

}  // namespace

Tessellation tessellate(const LimitSurface& surface, int n) {
  if (n < 1 || n > kMostDivisions) {
    throw std::invalid_argument("Cells can be divided into 1 to 256 parts a side, not " +
                                std::to_string(n) + ".");
  }
  return Builder(surface, CellDivisions(surface.cells(), n)).build();
}

Tessellation tessellate_to_tolerance(const LimitSurface& surface, double chord_tolerance) {
  return Builder(surface, chord_divisions_for(surface, chord_tolerance)).build();
}

}  // namespace hull::surface

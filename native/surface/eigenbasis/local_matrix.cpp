// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/local_matrix.h"

#include <cassert>
#include <limits>
#include <unordered_map>

#include "mesh/refined_view.h"

namespace hull::surface {
namespace {

using Row = Eigen::RowVectorXd;

// `faces` quadrilaterals around vertex 0, its ends 1 … and then the opposite corners.
mesh::Topology fan_topology(const CornerKey& key) {
  const int n = key.faces;
  // A sector between creases is a mesh of its own, with borders for the creases: the rules do not
  // look across. The fan of a dart, or of a cone with one crease, is closed, with a crease edge in
  // it.
  const bool open = key.kind == mesh::VertexKind::kCrease ||
                    (key.kind == mesh::VertexKind::kCorner && !key.closed);
  const int ends = open ? n + 1 : n;
  std::vector<int> vertices;
  for (int i = 0; i < n; ++i) {
    vertices.insert(vertices.end(), {0, 1 + i, 1 + ends + i, 1 + (i + 1) % ends});
  }
  std::vector<std::array<int, 2>> creases;
  if (!open && !key.closed) creases.push_back({0, 1});
  std::vector<int> corners;
  if (key.kind == mesh::VertexKind::kCorner || key.kind == mesh::VertexKind::kCone) {
    corners.push_back(0);
  }
  return mesh::Topology(1 + ends + n, std::vector<int>(n, 4), vertices, creases, corners,
                        /*round_border_corners=*/true);
}

// The aligned half-edge (from the child's lower left corner, along u) of child (i, j) of the cell
// of aligned half-edge h.
template <class T>
int child_half_edge(const T& t, int h, int i, int j) {
  if (j == 0) return i == 0 ? 4 * h : 4 * t.next(h) + 3;
  return i == 0 ? 4 * t.prev(h) + 1 : 4 * t.next(t.next(h)) + 2;
}

// Rows of weights at the origins of half-edges of one level, each computed once.
template <class T, class Coarse>
class RowsOf {
 public:
  RowsOf(const T& coarse, const Coarse& rows, Scheme scheme)
      : coarse_(coarse), fine_(coarse), rows_(rows), scheme_(scheme) {}
  const Row& operator()(int h) const {
    const auto [it, is_new] = known_.try_emplace(fine_.origin(h));
    if (is_new) it->second = refined_value<Row>(coarse_, scheme_, h, rows_);
    return it->second;
  }

 private:
  const T& coarse_;
  mesh::RefinedView<T> fine_;
  const Coarse& rows_;
  Scheme scheme_;
  mutable std::unordered_map<int, Row> known_;
};

template <class T, class Rows>
void add_segment(const T& t, const Rows& rows, int h, double u, double v, double size, int n,
                 std::vector<RingSegment>& segments) {
  const std::array<int, 16> grid = grid_points(t, h);
  std::array<Row, 16> values;
  for (int i = 0; i < 16; ++i) {
    values[i] = grid[i] == kNoPoint ? Row(Row::Zero(n)) : rows(grid[i]);
  }
  fill_ghosts(values, grid);
  RingSegment segment{u, v, size, {}, {}};
  segment.rows.resize(16, n);
  for (int i = 0; i < 16; ++i) segment.rows.row(i) = values[i];
  assert(segment.rows.allFinite());
  segments.push_back(std::move(segment));
}

}  // namespace

LocalMatrices local_matrices(const CornerKey& key) {
  // Two refinements put all other irregular points and borders out of reach.
  const mesh::Topology level0 = fan_topology(key).refined().refined();
  // Half-edge 4 cell of the fan leaves the centre; refining makes 4 h of h.
  const int h0 = 16 * 4 * key.cell;
  const mesh::RefinedView<mesh::Topology> level1(level0);
  const mesh::RefinedView<mesh::RefinedView<mesh::Topology>> level2(level1);

  const auto points_of = [](const auto& t, int h) {
    std::vector<int> points = ring_points(t, corner_fan(t, h));
    const std::vector<int> outer = outer_points(t, h);
    points.insert(points.end(), outer.begin(), outer.end());
    return points;
  };
  const std::vector<int> coarse = points_of(level0, h0);
  const int n = static_cast<int>(coarse.size());
  std::unordered_map<int, int> column;
  // Level 0 is where the cell's points are unknowns, a unit row each.
  for (int i = 0; i < n; ++i) column.emplace(level0.origin(coarse[i]), i);
  assert(static_cast<int>(column.size()) == n);
  // A point outside the neighbourhood must have no influence: were it used, NaN would show it.
  const Row outside = Row::Constant(n, std::numeric_limits<double>::quiet_NaN());
  const auto rows0 = [&](int h) -> Row {
    const auto it = column.find(level0.origin(h));
    return it == column.end() ? outside : Row(Row::Unit(n, it->second));
  };
  const RowsOf rows1(level0, rows0, key.scheme);
  const RowsOf rows2(level1, rows1, key.scheme);

  LocalMatrices result;
  result.ring_size = static_cast<int>(ring_points(level0, corner_fan(level0, h0)).size());
  result.A.resize(n, n);
  const std::vector<int> fine = points_of(level1, 4 * h0);
  for (int i = 0; i < n; ++i) result.A.row(i) = rows1(fine[i]);
  assert(result.A.allFinite());

  // The three children away from the knot, in the order of Stam's segments (Greshake 4.13).
  for (const auto& [i, j] : {std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    const int child = child_half_edge(level0, h0, i, j);
    if (is_regular_cell(level1, key.scheme, child)) {
      add_segment(level1, rows1, child, 0.5 * i, 0.5 * j, 0.5, n, result.segments);
      continue;
    }
    // Beside a modified edge: the quarters are spans (docs/surface.md, trap 2).
    for (int k = 0; k < 4; ++k) {
      const int p = k & 1, q = k >> 1;
      const int grandchild = child_half_edge(level1, child, p, q);
      assert(is_regular_cell(level2, key.scheme, grandchild));
      add_segment(level2, rows2, grandchild, 0.5 * i + 0.25 * p, 0.5 * j + 0.25 * q, 0.25, n,
                  result.segments);
    }
  }
  return result;
}

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/divide.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "conversion/patches/breaks.h"
#include "conversion/patches/edge_uses.h"
#include "conversion/patches/patch_rows.h"

namespace hull::conversion {
namespace {

// The edges that one is divided into, in the direction of its first use.
struct DividedEdge {
  std::vector<double> breaks;  // inside (0, 1), rising
  int first_edge = -1;         // the others' numbers follow
  int first_vertex = -1;       // at the first break; the others' numbers follow
};

// Numbers of the vertices and edges within one patch.
struct InnerGrid {
  int columns, rows;  // pieces along u and v
  int first_vertex, first_edge;

  int vertex(int i, int j) const { return first_vertex + (i - 1) * (rows - 1) + j - 1; }
  // From (i, j) to (i + 1, j), 0 < j < rows.
  int edge_along_u(int i, int j) const { return first_edge + i * (rows - 1) + j - 1; }
  // From (i, j) to (i, j + 1), 0 < i < columns.
  int edge_along_v(int i, int j) const {
    return first_edge + columns * (rows - 1) + (i - 1) * rows + j;
  }
  int vertex_count() const { return (columns - 1) * (rows - 1); }
  int edge_count() const { return columns * (rows - 1) + (columns - 1) * rows; }
};

class Divider {
 public:
  Divider(const PatchSet& set, const std::vector<PatchCuts>& cuts)
      : set_(set), cuts_(cuts), uses_(set), edges_(set.edge_count) {
    result_.vertex_count = set.vertex_count;
    result_.cell_faces = set.cell_faces;
  }

  PatchSet divide() {
    for (int edge = 0; edge < set_.edge_count; ++edge) divide_edge(edge);
    for (int p = 0; p < static_cast<int>(set_.patches.size()); ++p) divide_patch(p);
    unite_corners();
    return std::move(result_);
  }

 private:
  void divide_edge(int edge) {
    DividedEdge& divided = edges_[edge];
    for (int n = 0; n < 2; ++n) {
      const EdgeUse& use = uses_.of(edge)[n];
      if (use.patch < 0) continue;
      const SideEdge& part = uses_.part(use);
      for (double cut : cuts_along(use)) {
        // Sides 2 and 3 run against u and v, and the second use against the first.
        const double s = use.side < 2 ? cut : 1.0 - cut;
        const double t = (s - part.begin) / (part.end - part.begin);
        add_break(divided.breaks, n == 0 ? t : 1.0 - t);
      }
    }
    const int count = static_cast<int>(divided.breaks.size());
    divided.first_edge = result_.edge_count;
    divided.first_vertex = result_.vertex_count;
    result_.edge_count += count + 1;
    result_.vertex_count += count;
  }

  const std::vector<double>& cuts_along(const EdgeUse& use) const {
    return use.side % 2 == 0 ? cuts_[use.patch].u : cuts_[use.patch].v;
  }

  // Side k of patch p as its edges are now, still with parameters of the whole side.
  PatchSide divided_side(int p, int k) const {
    PatchSide result;
    for (int i = 0; i < static_cast<int>(set_.sides[p][k].size()); ++i) {
      const SideEdge& part = set_.sides[p][k][i];
      const DividedEdge& edge = edges_[part.edge];
      // The other use meets the edge's pieces in the opposite order.
      const bool is_first = uses_.of(part.edge)[0] == EdgeUse{p, k, i};
      const int count = static_cast<int>(edge.breaks.size());
      SideEdge rest = part;
      for (int n = 0; n <= count; ++n) {
        SideEdge piece = rest;
        piece.edge = edge.first_edge + (is_first ? n : count - n);
        if (n < count) {
          const int at = is_first ? n : count - 1 - n;
          const double t = is_first ? edge.breaks[at] : 1.0 - edge.breaks[at];
          piece.to = edge.first_vertex + at;
          piece.end = part.begin + t * (part.end - part.begin);
        }
        result.push_back(piece);
        rest.from = piece.to;
        rest.begin = piece.end;
      }
    }
    return result;
  }

  void divide_patch(int p) {
    const std::vector<double> u = with_ends(cuts_[p].u), v = with_ends(cuts_[p].v);
    const InnerGrid grid{static_cast<int>(u.size()) - 1, static_cast<int>(v.size()) - 1,
                         result_.vertex_count, result_.edge_count};
    result_.vertex_count += grid.vertex_count();
    result_.edge_count += grid.edge_count();
    std::array<PatchSide, 4> sides;
    for (int k = 0; k < 4; ++k) sides[k] = divided_side(p, k);
    for (int i = 0; i < grid.columns; ++i) {
      const BSplinePatch column = with_rows_along_u(
          set_.patches[p], [&](const BSplineCurve& row) { return row.part(u[i], u[i + 1]); });
      for (int j = 0; j < grid.rows; ++j) {
        result_.patches.push_back(with_rows_along_v(
            column, [&](const BSplineCurve& row) { return row.part(v[j], v[j + 1]); }));
        add_sides(grid, sides, u, v, i, j);
        add_block(p, u, v, i, j);
      }
    }
  }

  void add_sides(const InnerGrid& grid, const std::array<PatchSide, 4>& outer,
                 const std::vector<double>& u, const std::vector<double>& v, int i, int j) {
    std::array<PatchSide, 4> sides;
    sides[0] =
        j > 0 ? whole_side(grid.edge_along_u(i, j), -1, -1) : within(outer[0], u[i], u[i + 1]);
    sides[1] = i + 1 < grid.columns ? whole_side(grid.edge_along_v(i + 1, j), -1, -1)
                                    : within(outer[1], v[j], v[j + 1]);
    sides[2] = j + 1 < grid.rows ? whole_side(grid.edge_along_u(i, j + 1), -1, -1)
                                 : within(outer[2], 1.0 - u[i + 1], 1.0 - u[i]);
    sides[3] = i > 0 ? whole_side(grid.edge_along_v(i, j), -1, -1)
                     : within(outer[3], 1.0 - v[j + 1], 1.0 - v[j]);
    // Ends of inner edges are inner vertices, or where an outer side of this piece or the next one
    // begins.
    const std::array<std::array<int, 2>, 4> at{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    std::array<int, 4> corners{};
    for (int k = 0; k < 4; ++k) corners[k] = corner(grid, outer, u, v, at[k][0], at[k][1]);
    for (int k = 0; k < 4; ++k) {
      sides[k].front().from = corners[k];
      sides[k].back().to = corners[(k + 1) % 4];
    }
    result_.corners.push_back(corners);
    result_.sides.push_back(std::move(sides));
  }

  static int corner(const InnerGrid& grid, const std::array<PatchSide, 4>& outer,
                    const std::vector<double>& u, const std::vector<double>& v, int i, int j) {
    if (j == 0) return vertex_at(outer[0], u[i]);
    if (j == grid.rows) return vertex_at(outer[2], 1.0 - u[i]);
    if (i == 0) return vertex_at(outer[3], 1.0 - v[j]);
    if (i == grid.columns) return vertex_at(outer[1], v[j]);
    return grid.vertex(i, j);
  }

  static int vertex_at(const PatchSide& side, double s) {
    for (const SideEdge& part : side) {
      // A part begins at every cut, but for rounding.
      if (part.begin > s - kSameBreak) return part.from;
    }
    return side.back().to;
  }

  // The edges of a side from `begin` to `end`, with parameters of that part of it.
  static PatchSide within(const PatchSide& side, double begin, double end) {
    PatchSide result;
    for (SideEdge part : side) {
      if (part.end < begin + kSameBreak || part.begin > end - kSameBreak) continue;
      part.begin = (part.begin - begin) / (end - begin);
      part.end = (part.end - begin) / (end - begin);
      result.push_back(part);
    }
    result.front().begin = 0.0;
    result.back().end = 1.0;
    return result;
  }

  void add_block(int p, const std::vector<double>& u, const std::vector<double>& v, int i, int j) {
    if (set_.blocks.empty()) return;
    Block block = set_.blocks[p];
    // A patch may be a part of its block already.
    const double width = block.end_u - block.begin_u, height = block.end_v - block.begin_v;
    const double u0 = block.begin_u, v0 = block.begin_v;
    block.begin_u = u0 + u[i] * width;
    block.end_u = u0 + u[i + 1] * width;
    block.begin_v = v0 + v[j] * height;
    block.end_v = v0 + v[j + 1] * height;
    result_.blocks.push_back(std::move(block));
  }

  // Corners of different patches' pieces differ by rounding.
  void unite_corners() {
    std::vector<Vector3d> points(result_.vertex_count, Vector3d::Zero());
    std::vector<char> known(result_.vertex_count, 0);
    for (std::size_t p = 0; p < result_.patches.size(); ++p) {
      for (int k = 0; k < 4; ++k) {
        const int vertex = result_.corners[p][k];
        Vector3d& point = result_.patches[p].control_points[result_.patches[p].side_index(k, 0)];
        if (known[vertex]) {
          point = points[vertex];
        } else {
          points[vertex] = point;
          known[vertex] = 1;
        }
      }
    }
  }

  const PatchSet& set_;
  const std::vector<PatchCuts>& cuts_;
  EdgeUses uses_;
  std::vector<DividedEdge> edges_;
  PatchSet result_;
};

std::vector<double> inner_knots(const std::vector<double>& knots) {
  std::vector<double> result;
  for (double knot : knots) {
    if (knot > 0.0 && knot < 1.0 && (result.empty() || knot != result.back())) {
      result.push_back(knot);
    }
  }
  return result;
}

// Of `knots` those that part them into so many pieces, as evenly as can be.
std::vector<double> evenly(const std::vector<double>& knots, int pieces) {
  std::vector<double> result;
  const int intervals = static_cast<int>(knots.size()) + 1;
  for (int n = 1; n < pieces; ++n) result.push_back(knots[n * intervals / pieces - 1]);
  return result;
}

// Control points along one direction, at most, of pieces of a patch with simple knots.
// Cubics have three more control points than spans.
int most_along(int intervals, int pieces) { return (intervals + pieces - 1) / pieces + 3; }

}  // namespace

PatchSet divided(const PatchSet& set, const std::vector<PatchCuts>& cuts) {
  PatchSet result = Divider(set, cuts).divide();
  result.source = set.source;
  return result;
}

std::vector<PatchCuts> cuts_at_knots(const PatchSet& set) {
  std::vector<PatchCuts> cuts;
  for (const BSplinePatch& patch : set.patches) {
    cuts.push_back({inner_knots(patch.knots_u), inner_knots(patch.knots_v)});
  }
  return cuts;
}

std::vector<PatchCuts> cuts_for_most_points(const PatchSet& set, int most) {
  if (most < kLeastControlPoints) {
    throw std::invalid_argument("Patches can be limited to " + std::to_string(kLeastControlPoints) +
                                " control points or more, not to " + std::to_string(most) + ".");
  }
  std::vector<PatchCuts> cuts;
  for (const BSplinePatch& patch : set.patches) {
    const std::vector<double> u = inner_knots(patch.knots_u), v = inner_knots(patch.knots_v);
    const int along_u = static_cast<int>(u.size()) + 1, along_v = static_cast<int>(v.size()) + 1;
    int best_u = along_u, best_v = along_v;
    for (int pieces_u = 1; pieces_u <= along_u; ++pieces_u) {
      int pieces_v = 1;
      while (pieces_v < along_v &&
             most_along(along_u, pieces_u) * most_along(along_v, pieces_v) > most) {
        ++pieces_v;
      }
      if (most_along(along_u, pieces_u) * most_along(along_v, pieces_v) > most) continue;
      if (pieces_u * pieces_v < best_u * best_v) {
        best_u = pieces_u;
        best_v = pieces_v;
      }
    }
    cuts.push_back({evenly(u, best_u), evenly(v, best_v)});
  }
  return cuts;
}

}  // namespace hull::conversion

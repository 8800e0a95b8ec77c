// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/flat_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "mesh/groups.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

// The cross product of the derivatives is the longer one times the width across it.
bool is_flat(const BSplinePatch& patch, double width) {
  for (double u : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (double v : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const surface::SurfaceJet jet = patch.evaluate(u, v);
      // Where both are short the patch is a point there, which is flat as well.
      const double longer = std::max(jet.du.norm(), jet.dv.norm());
      if (longer > width && jet.du.cross(jet.dv).norm() > width * longer) return false;
    }
  }
  return true;
}

// Splits part `i` of a side of a patch at `share` of it, wherever its edge is used; `vertex` is the
// new ends' number.
void split(PatchSet& set, int p, int k, std::size_t i, double share, int vertex) {
  const SideEdge old = set.sides[p][k][i];
  const int fresh = set.edge_count++;
  for (auto& sides : set.sides) {
    for (PatchSide& side : sides) {
      for (std::size_t j = 0; j < side.size(); ++j) {
        if (side[j].edge != old.edge) continue;
        // The other use of the edge runs against this one.
        const bool backwards = side[j].from != old.from;
        const double at = backwards ? 1.0 - share : share;
        SideEdge first = side[j], second = side[j];
        first.end = second.begin = first.begin + at * (first.end - first.begin);
        first.to = second.from = vertex;
        (backwards ? first : second).edge = fresh;
        side[j] = first;
        side.insert(side.begin() + static_cast<std::ptrdiff_t>(++j), second);
      }
    }
  }
}

// Ends edges of one side where those of another do that lies on it the other way. Whether any had
// to be split.
bool match_edges(PatchSet& set, int p, int side, int other) {
  constexpr double kSameEnd = 1e-12;  // of the side: ends of edges differ by rounding
  const PatchSide theirs = set.sides[p][other];
  bool any = false;
  for (std::size_t i = 0; i + 1 < theirs.size(); ++i) {
    // The sides lie on one another the other way.
    const double at = 1.0 - theirs[i].end;
    for (std::size_t j = 0; j < set.sides[p][side].size(); ++j) {
      const SideEdge part = set.sides[p][side][j];
      if (at <= part.begin + kSameEnd || at >= part.end - kSameEnd) continue;
      split(set, p, side, j, (at - part.begin) / (part.end - part.begin), theirs[i].to);
      any = true;
      break;
    }
  }
  return any;
}

// The two sides of a flat patch that have a length, if there are two and they lie on one another;
// else twice -1.
std::array<int, 2> folded_sides(const BSplinePatch& patch, double tolerance) {
  std::vector<int> with_length;
  for (int k = 0; k < 4; ++k) {
    if (patch.side_length(k) > tolerance) with_length.push_back(k);
  }
  // Otherwise nothing tells which side lies on which.
  if (with_length.size() != 2) return {-1, -1};
  const auto [a, b] = std::pair(with_length[0], with_length[1]);
  if (gap_between(patch.side_curve(a), patch.side_curve(b).reversed()) > tolerance) return {-1, -1};
  return {a, b};
}

// Joins what lies beyond the folded sides of a flat patch. REQUIRES: their edges match.
void close_gap(const std::array<PatchSide, 4>& sides, const std::array<int, 2>& folded,
               mesh::Groups& edges, mesh::Groups& vertices) {
  const PatchSide &one = sides[folded[0]], &two = sides[folded[1]];
  for (std::size_t i = 0; i < one.size(); ++i) {
    const SideEdge& opposite = two[two.size() - 1 - i];
    edges.join(one[i].edge, opposite.edge);
    vertices.join(one[i].from, opposite.to);
    vertices.join(one[i].to, opposite.from);
  }
  for (int k = 0; k < 4; ++k) {
    if (k == folded[0] || k == folded[1]) continue;
    // Sides of no length: both their ends are one point.
    for (const SideEdge& part : sides[k]) vertices.join(part.from, part.to);
  }
}

// Gives joined vertices one number, and one point: that of the patch first met.
void unify_vertices(PatchSet& set, mesh::Groups& vertices) {
  std::vector<int> first_corner(set.vertex_count, -1);
  const auto point = [&](int p, int k) -> Vector3d& {
    return set.patches[p].control_points[set.patches[p].side_index(k, 0)];
  };
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (SideEdge& part : set.sides[p][k]) {
        part.from = vertices.find(part.from);
        part.to = vertices.find(part.to);
      }
      int& vertex = set.corners[p][k];
      vertex = vertices.find(vertex);
      int& first = first_corner[vertex];
      if (first < 0) first = 4 * p + k;
      point(p, k) = point(first / 4, first % 4);
    }
  }
}

// Gives joined edges one number. Where they are whole sides of alike patches they get one curve bit
// for bit, that of the patch first met; otherwise they must lie together as they are.
void unify_edges(PatchSet& set, mesh::Groups& edges) {
  struct Use {
    int patch = -1, side = -1;
    SideEdge part;
  };
  std::vector<Use> uses(set.edge_count);
  const double tolerance = kLargestGap * set.size();
  const auto point = [&](int p, int k, int i) -> Vector3d& {
    return set.patches[p].control_points[set.patches[p].side_index(k, i)];
  };
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (SideEdge& part : set.sides[p][k]) {
        const int edge = edges.find(part.edge);
        Use& use = uses[edge];
        if (use.patch < 0) use = {p, k, part};
        // The same edge, or the only use so far: nothing to compare.
        if ((use.patch == p && use.side == k) || use.part.edge == part.edge) {
          part.edge = edge;
          continue;
        }
        const int count = set.patches[p].side_count(k);
        if (set.sides[p][k].size() == 1 && set.sides[use.patch][use.side].size() == 1 &&
            count == set.patches[use.patch].side_count(use.side)) {
          for (int i = 0; i < count; ++i) {
            point(p, k, i) = point(use.patch, use.side, count - 1 - i);
          }
        }
        const double gap =
            gap_between(set.curve(p, k, part), set.curve(use.patch, use.side, use.part).reversed());
        // What does not lie together to rounding stays a border on either side.
        part.edge = gap <= tolerance ? edge : set.edge_count++;
      }
    }
  }
}

}  // namespace

WithoutFlatPatches without_flat_patches(const PatchSet& set) {
  const double tolerance = kNoLength * set.size();
  std::vector<char> is_left_out;
  for (const BSplinePatch& patch : set.patches) {
    // A set without a size is one point.
    is_left_out.push_back(tolerance == 0.0 || is_flat(patch, tolerance));
  }
  PatchSet all = set;
  const int count = static_cast<int>(set.patches.size());
  std::vector<std::array<int, 2>> folded(count, {-1, -1});
  for (int p = 0; p < count; ++p) {
    if (is_left_out[p]) folded[p] = folded_sides(set.patches[p], tolerance);
  }
  // An edge that is split may be on the side of another flat patch, which then has to follow.
  for (bool again = true; again;) {
    again = false;
    for (int p = 0; p < count; ++p) {
      const auto [a, b] = folded[p];
      if (a < 0) continue;
      again = match_edges(all, p, a, b) || again;
      again = match_edges(all, p, b, a) || again;
    }
  }
  mesh::Groups vertices(all.vertex_count), edges(all.edge_count);
  for (int p = 0; p < count; ++p) {
    if (folded[p][0] >= 0) close_gap(all.sides[p], folded[p], edges, vertices);
  }

  WithoutFlatPatches result;
  PatchSet& kept = result.patches;
  kept.vertex_count = all.vertex_count;
  kept.edge_count = all.edge_count;
  kept.source = std::move(all.source);
  kept.cell_faces = all.cell_faces;
  for (int p = 0; p < count; ++p) {
    result.is_kept.push_back(!is_left_out[p]);
    if (is_left_out[p]) {
      result.left_out.push_back(all.patches[p].cell);
      continue;
    }
    kept.patches.push_back(std::move(all.patches[p]));
    kept.corners.push_back(all.corners[p]);
    kept.sides.push_back(std::move(all.sides[p]));
    if (!all.blocks.empty()) kept.blocks.push_back(std::move(all.blocks[p]));
  }
  if (!result.left_out.empty()) {
    unify_vertices(kept, vertices);
    unify_edges(kept, edges);
  }
  return result;
}

}  // namespace hull::conversion

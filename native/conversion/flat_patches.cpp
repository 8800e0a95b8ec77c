// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/flat_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "conversion/groups.h"

namespace hull {
namespace {

constexpr double kFlat = 1e-9;  // of the size

// The cross product of the derivatives is the longer one times the width across it.
bool is_flat(const BSplinePatch& patch, double width) {
  for (double u : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (double v : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const SurfaceJet jet = patch.evaluate(u, v);
      const double longer = std::max(jet.du.norm(), jet.dv.norm());
      if (longer > width && jet.du.cross(jet.dv).norm() > width * longer) return false;
    }
  }
  return true;
}

bool lie_together(const std::vector<Vector3d>& one, std::vector<Vector3d> two, double tolerance) {
  std::ranges::reverse(two);
  if (one.size() != two.size()) return false;
  for (size_t i = 0; i < one.size(); ++i) {
    if ((one[i] - two[i]).norm() > tolerance) return false;
  }
  return true;
}

// Joins what lies beyond the two sides of a flat patch that have a length, if there are two and
// they lie on one another.
void close_gap(const PatchSet& set, int p, double tolerance, Groups& edges, Groups& vertices) {
  const BSplinePatch& patch = set.patches[p];
  std::vector<int> with_length, without;
  for (int k = 0; k < 4; ++k) {
    (patch.side_length(k) > tolerance ? with_length : without).push_back(k);
  }
  if (with_length.size() != 2) return;
  const auto [a, b] = std::pair(with_length[0], with_length[1]);
  if (!lie_together(patch.side_points(a), patch.side_points(b), tolerance)) return;
  edges.join(set.sides[p][a], set.sides[p][b]);
  for (int k : without) vertices.join(set.corners[p][k], set.corners[p][(k + 1) % 4]);
}

// Gives joined edges and vertices one number, and one curve or point: that of the patch first met.
void unify(PatchSet& set, Groups& edges, Groups& vertices) {
  std::vector<int> first_corner(set.vertex_count, -1), first_side(set.edge_count, -1);
  const auto point = [&](int p, int k, int i) -> Vector3d& {
    return set.patches[p].control_points[set.patches[p].side_index(k, i)];
  };
  const int count = static_cast<int>(set.patches.size());
  for (int p = 0; p < count; ++p) {
    for (int k = 0; k < 4; ++k) {
      int& vertex = set.corners[p][k];
      vertex = vertices.find(vertex);
      int& first = first_corner[vertex];
      if (first < 0) first = 4 * p + k;
      point(p, k, 0) = point(first / 4, first % 4, 0);
    }
  }
  for (int p = 0; p < count; ++p) {
    for (int k = 0; k < 4; ++k) {
      int& edge = set.sides[p][k];
      edge = edges.find(edge);
      int& first = first_side[edge];
      if (first < 0) {
        first = 4 * p + k;
        continue;
      }
      const int last = set.patches[p].side_count(k) - 1;
      for (int i = 0; i <= last; ++i) point(p, k, i) = point(first / 4, first % 4, last - i);
    }
  }
}

}  // namespace

WithoutFlatPatches without_flat_patches(const PatchSet& set) {
  const double tolerance = kFlat * set.size();
  Groups edges(set.edge_count), vertices(set.vertex_count);
  WithoutFlatPatches result;
  PatchSet& kept = result.patches;
  kept.vertex_count = set.vertex_count;
  kept.edge_count = set.edge_count;
  kept.report = set.report;
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    if (tolerance == 0.0 || is_flat(set.patches[p], tolerance)) {
      close_gap(set, p, tolerance, edges, vertices);
      result.left_out.push_back(set.patches[p].cell);
    } else {
      kept.patches.push_back(set.patches[p]);
      kept.corners.push_back(set.corners[p]);
      kept.sides.push_back(set.sides[p]);
    }
  }
  if (!result.left_out.empty()) unify(kept, edges, vertices);
  return result;
}

}  // namespace hull

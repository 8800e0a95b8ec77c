// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patch_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hull {
namespace {

// Reversing a knot vector rounds.
constexpr double kKnotRounding = 1e-15;

struct Use {
  int patch = -1, side = -1;
};

[[noreturn]] void refuse(const BSplinePatch& patch, const std::string& what) {
  throw std::invalid_argument("patch of cell " + std::to_string(patch.cell) + ": " + what);
}

void check_numbers(const PatchSet& set) {
  const size_t count = set.patches.size();
  if (set.corners.size() != count || set.sides.size() != count) {
    throw std::invalid_argument(std::to_string(count) + " patches, but corners of " +
                                std::to_string(set.corners.size()) + " and sides of " +
                                std::to_string(set.sides.size()));
  }
  for (size_t p = 0; p < count; ++p) {
    for (int k = 0; k < 4; ++k) {
      const int vertex = set.corners[p][k], edge = set.sides[p][k];
      if (vertex < 0 || vertex >= set.vertex_count) {
        refuse(set.patches[p], "there is no vertex " + std::to_string(vertex));
      }
      if (edge < 0 || edge >= set.edge_count) {
        refuse(set.patches[p], "there is no edge " + std::to_string(edge));
      }
    }
  }
}

// The second patch of an edge runs along it the other way.
void check_joint(const PatchSet& set, const Use& first, const Use& second) {
  const BSplinePatch &one = set.patches[first.patch], &two = set.patches[second.patch];
  const int begin_one = set.corners[first.patch][first.side];
  const int begin_two = set.corners[second.patch][second.side];
  const int end_one = set.corners[first.patch][(first.side + 1) % 4];
  const int end_two = set.corners[second.patch][(second.side + 1) % 4];
  const std::string edge = "edge " + std::to_string(set.sides[first.patch][first.side]);
  const std::string other = " as the patch of cell " + std::to_string(one.cell);
  if (begin_one != end_two || end_one != begin_two) {
    refuse(two, edge + " does not run between the same vertices, the other way," + other);
  }
  std::vector<Vector3d> points = two.side_points(second.side);
  std::ranges::reverse(points);
  if (points != one.side_points(first.side)) refuse(two, edge + " has not the same curve" + other);
  const std::vector<double> knots = one.side_knots(first.side);
  std::vector<double> others = two.side_knots(second.side);
  std::ranges::reverse(others);
  bool same = knots.size() == others.size();
  for (size_t i = 0; same && i < knots.size(); ++i) {
    same = std::abs(knots[i] - (1.0 - others[i])) <= kKnotRounding;
  }
  if (!same) refuse(two, edge + " has not the same knots" + other);
}

}  // namespace

double PatchSet::size() const {
  Eigen::AlignedBox3d box;
  for (const BSplinePatch& patch : patches) {
    for (const Vector3d& point : patch.control_points) box.extend(point);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

void PatchSet::check() const {
  for (const BSplinePatch& patch : patches) patch.check();
  check_numbers(*this);
  std::vector<Use> edge_use(edge_count), vertex_use(vertex_count);
  std::vector<bool> full(edge_count, false);
  for (int p = 0; p < static_cast<int>(patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      Use& vertex = vertex_use[corners[p][k]];
      if (vertex.patch < 0) vertex = {p, k};
      const Vector3d corner = patches[p].side_points(k).front();
      if (corner != patches[vertex.patch].side_points(vertex.side).front()) {
        refuse(patches[p], "vertex " + std::to_string(corners[p][k]) + " is not where cell " +
                               std::to_string(patches[vertex.patch].cell) + " has it");
      }
      const int edge = sides[p][k];
      if (full[edge])
        refuse(patches[p], "edge " + std::to_string(edge) + " has more than 2 patches");
      if (edge_use[edge].patch >= 0) {
        check_joint(*this, edge_use[edge], {p, k});
        full[edge] = true;
      } else {
        edge_use[edge] = {p, k};
      }
    }
  }
}

}  // namespace hull

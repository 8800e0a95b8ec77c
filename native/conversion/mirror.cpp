// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/mirror.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hull {
namespace {

constexpr double kSeamTolerance = 1e-7;  // of the size

struct Seam {
  std::vector<bool> edges, vertices;
};

Seam find_seam(const PatchSet& set) {
  const double tolerance = kSeamTolerance * set.size();
  std::vector<int> uses(set.edge_count, 0);
  for (const auto& sides : set.sides) {
    for (int edge : sides) ++uses[edge];
  }
  Seam seam{std::vector<bool>(set.edge_count, false), std::vector<bool>(set.vertex_count, false)};
  for (size_t p = 0; p < set.patches.size(); ++p) {
    for (int k = 0; k < 4; ++k) {
      if (uses[set.sides[p][k]] != 1) continue;
      const bool flat = std::ranges::all_of(
          set.patches[p].side_points(k),
          [&](const Vector3d& point) { return std::abs(point.y()) <= tolerance; });
      if (!flat) continue;
      seam.edges[set.sides[p][k]] = true;
      seam.vertices[set.corners[p][k]] = seam.vertices[set.corners[p][(k + 1) % 4]] = true;
    }
  }
  return seam;
}

void flatten(BSplinePatch& patch, const std::array<int, 4>& corners,
             const std::array<int, 4>& sides, const Seam& seam) {
  auto to_plane = [&](int side, int i) {
    patch.control_points[patch.side_index(side, i)].y() = 0.0;
  };
  for (int k = 0; k < 4; ++k) {
    if (seam.vertices[corners[k]]) to_plane(k, 0);
    if (!seam.edges[sides[k]]) continue;
    for (int i = 0; i < patch.side_count(k); ++i) to_plane(k, i);
  }
}

// Numbers of the image's edges or vertices: those of the seam are kept, the others get new ones.
std::vector<int> image_numbers(const std::vector<bool>& on_seam, int& count) {
  std::vector<int> numbers(on_seam.size());
  for (size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = on_seam[i] ? static_cast<int>(i) : count++;
  return numbers;
}

}  // namespace

PatchSet with_mirror_image(const PatchSet& half) {
  const Seam seam = find_seam(half);
  PatchSet whole = half;
  const std::vector<int> vertices = image_numbers(seam.vertices, whole.vertex_count);
  const std::vector<int> edges = image_numbers(seam.edges, whole.edge_count);
  for (size_t p = 0; p < half.patches.size(); ++p) {
    flatten(whole.patches[p], half.corners[p], half.sides[p], seam);
  }
  for (size_t p = 0; p < half.patches.size(); ++p) {
    BSplinePatch image = whole.patches[p].transposed();
    for (Vector3d& point : image.control_points) point.y() = 0.0 - point.y();  // never -0
    const std::array<int, 4>&c = half.corners[p], &s = half.sides[p];
    whole.patches.push_back(std::move(image));
    whole.corners.push_back({vertices[c[0]], vertices[c[3]], vertices[c[2]], vertices[c[1]]});
    whole.sides.push_back({edges[s[3]], edges[s[2]], edges[s[1]], edges[s[0]]});
  }
  return whole;
}

}  // namespace hull

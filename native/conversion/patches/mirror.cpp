// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/mirror.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

struct MirrorSeam {
  std::vector<bool> edges, vertices;
};

MirrorSeam find_seam(const PatchSet& set) {
  const double size = set.size();
  std::vector<int> uses(set.edge_count, 0);
  for (const auto& sides : set.sides) {
    for (const PatchSide& side : sides) {
      for (const SideEdge& part : side) ++uses[part.edge];
    }
  }
  MirrorSeam seam{std::vector<bool>(set.edge_count, false),
                  std::vector<bool>(set.vertex_count, false)};
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (const SideEdge& part : set.sides[p][k]) {
        // Only borders: an edge of two patches in the plane is the middle of something thin.
        if (uses[part.edge] != 1) continue;
        if (!lies_in_centre_plane(set.curve(p, k, part), size)) continue;
        seam.edges[part.edge] = true;
        seam.vertices[part.from] = seam.vertices[part.to] = true;
      }
    }
  }
  return seam;
}

// Puts what the seam's curve in a part of a side is made of on the plane. Other control points of
// the side stay, however near they are: another patch may have them, which has no seam there.
void flatten_part(BSplinePatch& patch, int side, const SideEdge& part, double tolerance) {
  const std::vector<double> knots = patch.side_knots(side);
  for (int i = 0; i < patch.side_count(side); ++i) {
    // Function i lives between knots i and i + degree + 1.
    if (knots[i] >= part.end || knots[i + patch.side_degree(side) + 1] <= part.begin) continue;
    double& y = patch.control_points[patch.side_index(side, i)].y();
    if (std::abs(y) <= tolerance) y = 0.0;
  }
}

void flatten(BSplinePatch& patch, const std::array<int, 4>& corners,
             const std::array<PatchSide, 4>& sides, const MirrorSeam& seam, double tolerance) {
  for (int k = 0; k < 4; ++k) {
    double& y = patch.control_points[patch.side_index(k, 0)].y();
    if (seam.vertices[corners[k]] && std::abs(y) <= tolerance) y = 0.0;
    for (const SideEdge& part : sides[k]) {
      if (seam.edges[part.edge]) flatten_part(patch, k, part, tolerance);
    }
  }
}

// The side of the image that runs the other way.
PatchSide image_of(const PatchSide& side, const std::vector<int>& vertices,
                   const std::vector<int>& edges) {
  PatchSide image;
  for (auto part = side.rbegin(); part != side.rend(); ++part) {
    image.push_back({edges[part->edge], vertices[part->to], vertices[part->from], 1.0 - part->end,
                     1.0 - part->begin});
  }
  return image;
}

// Numbers of the image's edges or vertices: those of the seam are kept, the others get new ones.
std::vector<int> image_numbers(const std::vector<bool>& on_seam, int& count) {
  std::vector<int> numbers(on_seam.size());
  for (size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = on_seam[i] ? static_cast<int>(i) : count++;
  }
  return numbers;
}

PatchSet flattened(const PatchSet& half, const MirrorSeam& seam) {
  PatchSet result = half;
  const double tolerance = kNoLength * half.size();
  for (size_t p = 0; p < half.patches.size(); ++p) {
    flatten(result.patches[p], half.corners[p], half.sides[p], seam, tolerance);
  }
  return result;
}

}  // namespace

bool lies_in_centre_plane(const BSplineCurve& curve, double size) {
  double farthest = 0.0;
  for (const Vector3d& point : curve.points) farthest = std::max(farthest, std::abs(point.y()));
  return farthest <= kNoLength * size;
}

PatchSet with_seam_in_plane(const PatchSet& half) { return flattened(half, find_seam(half)); }

PatchSet with_mirror_image(const PatchSet& half) {
  const MirrorSeam seam = find_seam(half);
  PatchSet whole = flattened(half, seam);
  if (!half.blocks.empty()) whole.blocks.resize(2 * half.patches.size());
  const std::vector<int> vertices = image_numbers(seam.vertices, whole.vertex_count);
  const std::vector<int> edges = image_numbers(seam.edges, whole.edge_count);
  for (size_t p = 0; p < half.patches.size(); ++p) {
    BSplinePatch image = whole.patches[p].transposed();
    for (Vector3d& point : image.control_points) point.y() = 0.0 - point.y();  // never -0
    const std::array<int, 4>& c = half.corners[p];
    whole.patches.push_back(std::move(image));
    // Transposed, the image runs the other way round and so has its normal outside again.
    whole.corners.push_back({vertices[c[0]], vertices[c[3]], vertices[c[2]], vertices[c[1]]});
    std::array<PatchSide, 4> sides;
    // With u and v exchanged side 3 - k is side k, run the other way.
    for (int k = 0; k < 4; ++k) sides[k] = image_of(half.sides[p][3 - k], vertices, edges);
    whole.sides.push_back(std::move(sides));
  }
  return whole;
}

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/control_faces.h"

#include <limits>

namespace hull::conversion {

std::vector<int> faces_of_cells(const surface::LimitSurface& surface) {
  const mesh::Topology& topology = surface.mesh().topology();
  std::vector<int> faces;
  // Cell c comes from half-edge c of the control mesh.
  for (int h = 0; h < topology.half_edge_count(); ++h) faces.push_back(topology.face(h));
  return faces;
}

int nearest_control_face(const PatchSet& set, const Vector3d& point) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](const BSplinePatch& patch, int cell, double u, double v) {
    // To samples, not to the patch: a message is to name a face near by.
    const double distance = (patch.position(u, v) - point).norm();
    if (cell < 0 || cell >= static_cast<int>(set.cell_faces.size()) || !(distance < least)) return;
    least = distance;
    nearest = set.cell_faces[cell];
  };
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    const BSplinePatch& patch = set.patches[p];
    if (set.blocks.empty() || set.blocks[p].sides.empty()) {
      take(patch, patch.cell, 0.5, 0.5);
      continue;
    }
    const Block& block = set.blocks[p];
    for (int i = 0; i < block.count_u; ++i) {
      for (int j = 0; j < block.count_v; ++j) {
        // A patch may be a part of its block.
        const double u =
            ((i + 0.5) / block.count_u - block.begin_u) / (block.end_u - block.begin_u);
        const double v =
            ((j + 0.5) / block.count_v - block.begin_v) / (block.end_v - block.begin_v);
        if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) continue;
        take(patch, block.side(i, j) / 4, u, v);
      }
    }
    // A part may hold the middle of no cell.
    const int at_u = static_cast<int>(0.5 * (block.begin_u + block.end_u) * block.count_u);
    const int at_v = static_cast<int>(0.5 * (block.begin_v + block.end_v) * block.count_v);
    take(patch, block.side(at_u, at_v) / 4, 0.5, 0.5);
  }
  return nearest;
}

}  // namespace hull::conversion

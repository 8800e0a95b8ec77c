// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/block_places.h"

#include <algorithm>

namespace hull::conversion {

std::vector<Vector3d> vertex_points(const surface::LimitSurface& surface) {
  const mesh::Topology& cells = surface.cells();
  std::vector<Vector3d> points(cells.vertex_count(), Vector3d::Zero());
  std::vector<char> known(points.size(), 0);
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    const int vertex = cells.origin(h);
    if (known[vertex]) continue;
    points[vertex] = point_on_half_edge(surface, h, 0.0);
    known[vertex] = 1;
  }
  return points;
}

CellPoint place_in_block(const Block& block, double u, double v) {
  const double at_u = (block.begin_u + u * (block.end_u - block.begin_u)) * block.count_u;
  const double at_v = (block.begin_v + v * (block.end_v - block.begin_v)) * block.count_v;
  // The end of the block is that of its last cell.
  const int i = std::min(static_cast<int>(at_u), block.count_u - 1);
  const int j = std::min(static_cast<int>(at_v), block.count_v - 1);
  return place_beside_half_edge(block.side(i, j), std::clamp(at_u - i, 0.0, 1.0),
                                std::clamp(at_v - j, 0.0, 1.0));
}

bool is_on_side(const Block& block, int k) {
  return k == 0   ? block.begin_v == 0.0
         : k == 1 ? block.end_u == 1.0
         : k == 2 ? block.end_v == 1.0
                  : block.begin_u == 0.0;
}

std::array<double, 2> part_of_side(const Block& block, int k) {
  const auto [begin, end] =
      k % 2 == 0 ? std::array{block.begin_u, block.end_u} : std::array{block.begin_v, block.end_v};
  return k < 2 ? std::array{begin, end} : std::array{1.0 - end, 1.0 - begin};
}

}  // namespace hull::conversion

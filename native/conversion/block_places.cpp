// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/block_places.h"

#include <algorithm>

namespace hull {

CellPoint place_in_block(const Block& block, double u, double v) {
  const double at_u = u * block.count_u, at_v = v * block.count_v;
  const int i = std::min(static_cast<int>(at_u), block.count_u - 1);
  const int j = std::min(static_cast<int>(at_v), block.count_v - 1);
  return place_beside_half_edge(block.side(i, j), std::clamp(at_u - i, 0.0, 1.0),
                                std::clamp(at_v - j, 0.0, 1.0));
}

}  // namespace hull

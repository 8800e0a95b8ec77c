// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "production/grid/side_points.h"

namespace hull::production {

// Numbers of the points of all cells' grids, those of common sides and corners shared.
class GridPoints {
 public:
  // Throws std::invalid_argument if there were more than 2^31.
  GridPoints(const mesh::Topology& cells, const surface::CellDivisions& divisions);

  int count() const { return count_; }
  int at(int cell, int i, int j) const;
  // Point k of the side of half-edge h, from its origin.
  int on_side(int h, int k) const;

 private:
  const mesh::Topology& cells_;
  const surface::CellDivisions& divisions_;
  int count_ = 0;
  std::vector<int> vertices_, edges_, cells_first_;
};

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::surface {

// How many parts each cell is divided into along u and v. Cells that share a side divide it alike,
// so that all cells of a strip, a chain of opposite sides, have one number.
class CellDivisions {
 public:
  // All strips in `n` parts.
  CellDivisions(const mesh::Topology& cells, int n);

  // Of the side of half-edge h of the cells' topology.
  int side(int h) const { return counts_[strip(h)]; }
  int u(int cell) const { return side(4 * cell); }
  int v(int cell) const { return side(4 * cell + 1); }
  // Quadrilaterals of all cells.
  double quad_count() const;

  int strip_count() const { return static_cast<int>(counts_.size()); }
  int strip(int h) const { return strip_of_edge_[cells_->edge(h)]; }
  void set(int strip, int parts) { counts_[strip] = parts; }

 private:
  const mesh::Topology* cells_;
  std::vector<int> strip_of_edge_, counts_;
};

inline constexpr int kMostDivisions = 256;
inline constexpr double kMostQuads = 1 << 24;

// Divisions for which every point of a cell is certainly within `tolerance`, m, of the
// quadrilateral that it belongs to, for either way of cutting that into triangles; about as few as
// that takes. None where more than kMostDivisions or kMostQuads would be needed.
std::optional<CellDivisions> chord_divisions(const LimitSurface& surface, double tolerance);

// The same; where there are none std::invalid_argument names a tolerance that would do, as it says
// what is wrong with one that is no length.
CellDivisions chord_divisions_for(const LimitSurface& surface, double chord_tolerance);

}  // namespace hull::surface

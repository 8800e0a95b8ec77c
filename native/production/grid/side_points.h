// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"
#include "surface/sampling/chord_divisions.h"

namespace hull::production {

// Where the sides of a surface's cells are divided: as many parts as CellDivisions tells, equal
// ones in the parameter unless told otherwise. Within a cell lines join points of the same number
// on opposite sides.
class SidePoints {
 public:
  SidePoints(const mesh::Topology& cells, surface::CellDivisions divisions);

  const surface::CellDivisions& divisions() const { return divisions_; }

  // Parameters, rising from 0 to 1 along the edge's front half-edge, one more than it has parts.
  void set(int edge, std::vector<double> parameters) { parameters_[edge] = std::move(parameters); }

  // The parameter along half-edge h of its point k, k = 0 at the origin of h.
  double along(int h, int k) const;

  // Of a cell's point (i, j), 0 <= i <= divisions().u(cell), 0 <= j <= divisions().v(cell).
  Eigen::Vector2d uv(int cell, int i, int j) const;

 private:
  const mesh::Topology* cells_;
  surface::CellDivisions divisions_;
  std::vector<std::vector<double>> parameters_;  // by edge; empty where parts are equal
};

}  // namespace hull::production

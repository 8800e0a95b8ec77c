// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/side_points.h"

#include <utility>

namespace hull::production {

SidePoints::SidePoints(const mesh::Topology& cells, surface::CellDivisions divisions)
    : cells_(&cells), divisions_(std::move(divisions)), parameters_(cells.edge_count()) {}

double SidePoints::along(int h, int k) const {
  const std::vector<double>& parameters = parameters_[cells_->edge(h)];
  const int n = divisions_.side(h);
  if (parameters.empty()) return static_cast<double>(k) / n;
  return cells_->is_edge_front(h) ? parameters[k] : 1.0 - parameters[n - k];
}

// The crossing of the straight lines, in (u, v), that join points i of the sides v = 0 and 1, and
// points j of the sides u = 0 and 1. Their slopes are below 1, so that they cross once.
Eigen::Vector2d SidePoints::uv(int cell, int i, int j) const {
  const int h = 4 * cell, nu = divisions_.u(cell), nv = divisions_.v(cell);
  // Sides 2 and 3 run against u and v: their numbers count down, and so do their parameters.
  const double low = along(h, i), high = 1.0 - along(h + 2, nu - i);
  const double left = 1.0 - along(h + 3, nv - j), right = along(h + 1, j);
  const double lean = high - low, rise = right - left;
  const double u = (low + left * lean) / (1.0 - rise * lean);
  return {u, left + u * rise};
}

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// All cells that have a point in common, and where each has it.
using CellPlaces = std::vector<surface::CellPlace>;

// The given place first, as it is; a place is on a side or a corner of its cell where u or v is
// within 1e-9 of 0 or 1. REQUIRES: `cells` as LimitSurface::cells(); u and v in [0, 1].
CellPlaces cell_places(const mesh::Topology& cells, int cell, const Eigen::Vector2d& uv);

// Whether a place is in no other cell.
bool is_inside_cell(const Eigen::Vector2d& uv);

}  // namespace hull::analysis

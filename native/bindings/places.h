// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bindings/arrays.h"
#include "surface/limit_surface.h"

namespace hull::bindings {

struct Places {
  std::vector<int> cells;
  std::vector<Eigen::Vector2d> uv;
};

// Cells (k,) and uv (k, 2) as given to queries of a surface. Raises ValueError naming what is
// outside of it.
Places places_from(const surface::LimitSurface& surface, const py::object& cells,
                   const DoubleArray& uv);

}  // namespace hull::bindings

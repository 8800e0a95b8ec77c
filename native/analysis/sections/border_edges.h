// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::analysis {

// The surface's border along one side of a cell: a cubic, by its Bézier points, run through with
// the surface on its left, seen from the water.
struct BorderEdge {
  int half_edge;  // of LimitSurface::cells()
  int loop;       // number of the closed border curve it belongs to
  std::array<Vector3d, 4> points;

  // The cubic of a coordinate direction·p - offset.
  std::array<double, 4> along(const Vector3d& direction, double offset) const;
};

// All of them, loop by loop, each loop in its order.
std::vector<BorderEdge> border_edges(const surface::LimitSurface& surface);

}  // namespace hull::analysis

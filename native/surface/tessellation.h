// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/limit_surface.h"

namespace hull {

// Points of a limit surface joined by quadrilaterals.
struct Tessellation {
  std::vector<Vector3d> points;           // m
  std::vector<int> cells;                 // per point: a cell it lies in …
  std::vector<Eigen::Vector2d> uv;        // … and where in it
  std::vector<std::array<int, 4>> quads;  // counter-clockwise; n * n of each cell, in cell order
  std::vector<std::array<Vector3d, 4>> corner_normals;  // per quad; they differ across creases
};

// n x n quadrilaterals per cell; cells share the points of their common sides, so there are no
// gaps. Throws std::invalid_argument unless 1 <= n <= 256.
Tessellation tessellate(const LimitSurface& surface, int n);

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::surface {

// Points of a limit surface joined by quadrilaterals. Cells share the points of their common sides,
// so there are no gaps. Cells on both sides of a crease have normals of their own there, and so
// have the sectors of a vertex; all others share them.
struct Tessellation {
  std::vector<Vector3d> points;           // m
  std::vector<int> cells;                 // per point: a cell it lies in …
  std::vector<Eigen::Vector2d> uv;        // … and where in it
  std::vector<std::array<int, 4>> quads;  // points, counter-clockwise; of each cell in cell order
  std::vector<Vector3d> normals;  // exact, of unit length; zero where there is no tangent plane
  std::vector<int> normal_cells;  // per normal: a cell that has it …
  std::vector<Eigen::Vector2d> normal_uv;          // … and where
  std::vector<std::array<int, 4>> corner_normals;  // per quad: of its corners, indices of normals
};

// n x n quadrilaterals per cell. Throws std::invalid_argument unless 1 <= n <= 256.
Tessellation tessellate(const LimitSurface& surface, int n);

// As many as it takes for every point of the surface to be within `chord_tolerance`, m, of its
// quadrilateral, whichever way that is cut into triangles: nu x nv in each cell, rows of cells
// divided alike. Throws std::invalid_argument, naming a tolerance that would do, where that takes
// more than 256 divisions of a cell, or 2^24 quadrilaterals. Divisions go with the reciprocal of
// the tolerance's square root; beside irregular points, where lines of equal u or v bend within the
// surface at every scale, with the reciprocal of the tolerance once that is small.
Tessellation tessellate_to_tolerance(const LimitSurface& surface, double chord_tolerance);

}  // namespace hull::surface

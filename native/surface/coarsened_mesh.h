// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/control_mesh.h"
#include "surface/limit_surface.h"

namespace hull::surface {

// The control mesh that another one was subdivided from: the reverse of refined_mesh().
struct CoarsenedMesh {
  mesh::ControlMesh mesh;   // with all tags; isolated points stay where they are
  std::vector<int> points;  // of the finer mesh, which became its control points, rising
  // The half-edge of each of its cells in the finer mesh that begins at the cell's control point,
  // in the order of cells.
  std::vector<int> cells;
  // Distances of the finer mesh's points from where this one, subdivided, has them, m: 0 but for
  // rounding unless they were moved since.
  double rms, largest;
  int largest_point;
};

// Takes the control mesh of a surface back to the one that it was subdivided from, by the surface's
// scheme. Where points were moved since, the sum of squares of the distances is least. Where faces
// can be put together in several ways, as in rings of them, the nearest counts.
//
// Throws std::invalid_argument where faces and creases are no subdivided ones, naming a point.
CoarsenedMesh coarsened_mesh(const LimitSurface& surface);

}  // namespace hull::surface

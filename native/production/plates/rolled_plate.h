// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/edge_development.h"
#include "production/plates/plate_mesh.h"

namespace hull::production {

// A plate rolled onto the plane from a corner near its middle, side by side of its triangles.
struct RolledPlate {
  std::vector<PlaneFrame> frames;      // of the mesh's corners
  std::vector<Eigen::Vector2d> nodes;  // of all nodes, m
  // How far apart points come where the plane is reached by two ways, m; and the angle of these
  // ways, rad: both are rounding where the surface is developable.
  double gap = 0.0, turn = 0.0;
};

RolledPlate rolled_plate(const PlateMesh& mesh, const Vector3d& middle);

}  // namespace hull::production

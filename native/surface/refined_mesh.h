// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/control_mesh.h"
#include "surface/limit_surface.h"

namespace hull::surface {

// The once-subdivided control mesh of a surface, by its scheme, as a control mesh with all tags:
// the surface of it is the same. Points and faces are in the order of Topology::refined(); every
// face has four corners. Isolated points stay where they are.
//
// Throws std::invalid_argument where it would have more points or faces than a mesh may have
// (mesh_check.h).
mesh::ControlMesh refined_mesh(const LimitSurface& surface);

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::mesh {

// m: the least extent that the points of a mesh's faces have along some axis. Below it the mesh has
// no size that tolerances could be parts of, and check_mesh() and ControlMesh::with_points() refuse
// it.
inline constexpr double kLeastSize = 1e-9;

}  // namespace hull::mesh

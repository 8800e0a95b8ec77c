// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/control_mesh.h"

namespace hull::morphing {

// Of each vertex of `mesh` the vertex of `other` that stands in the same place, where both are the
// same mesh but for the numbers and the order of vertices and faces: with faces around vertices,
// creases and kinds alike. None where they are not, or where a vertex has no face.
//
// A mesh that goes into itself in several ways, as a symmetric one does, has several such maps:
// that is taken which leads to the nearest points, each in its mesh's box. It is found body by
// body, by following faces from one half-edge: in time that goes with the square of the size at
// worst, and nearly with the size where half-edges are told apart soon.
std::optional<std::vector<int>> renumbering(const mesh::ControlMesh& mesh,
                                            const mesh::ControlMesh& other);

}  // namespace hull::morphing

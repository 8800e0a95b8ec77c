// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/topology.h"

namespace hull::mesh {

// The faces that a mesh would have been subdivided from (Topology::refined()): each of its
// quadrilaterals is a cell, with a corner at a vertex point, one in the middle of an edge, one at
// the middle of a face, and one in the middle of the edge before.
struct ParentFaces {
  // The half-edge of each cell that begins at its vertex point; cells of a parent's face one after
  // the other, counter-clockwise. Faces are in the order of their first cells.
  std::vector<int> cells;
  std::vector<int> sizes;  // of the parent's faces
};

// All ways in which each connected part of a mesh is a subdivided one, parts in the order of their
// first faces. There is mostly one; a ring or a torus of quadrilaterals has several.
//
// Throws std::invalid_argument where a part has none, naming the point of the mesh at which the
// least is at odds with it.
std::vector<std::vector<ParentFaces>> parent_faces(const Topology& mesh);

}  // namespace hull::mesh

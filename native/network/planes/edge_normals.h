// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/planes/region_faces.h"
#include "network/planes/tangent_planes.h"

namespace hull::network {

// Normals at a place of an edge, and their derivative by its parameter.
struct NormalJet {
  Vector3d normal, slope;
};

// Normals along an edge on one side of it: a cubic through those at its nodes, with the slopes of
// parabolas through those of three nodes along the curve (Bessel), where they are not too unevenly
// apart. Regions on both sides of an edge that is no crease have the same. Nodes whose edges tell
// of no plane on that side (where others end from beyond a knuckle) are passed over.
struct NormalField {
  Vector3d start, end;              // unit
  Vector3d start_slope, end_slope;  // by the edge's parameter

  NormalJet at(double u) const;
};

// What the surface is along the edges: to the left of each, and to its right.
struct EdgeNormals {
  std::vector<NormalField> left, right;
  std::vector<TangentPlanes> planes;  // of the nodes, by NodeOrder::around
  std::vector<bool> is_crease;        // of the edges: with two tangent planes somewhere
};

// `is_knuckle`: of curves, whether they are said to be knuckles of the surface. `limit`, rad: how
// far edges may be off their node's plane.
EdgeNormals edge_normals(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                         const NodeOrder& order, const RegionFaces& faces,
                         const std::vector<bool>& is_knuckle, double limit);

}  // namespace hull::network

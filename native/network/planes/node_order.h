// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/joining/edge_shape.h"
#include "network/topology/regions.h"

namespace hull::network {

// The ends of edges around each node, counterclockwise seen from outside, and the directions seen
// from (unit, outwards; they are no normals where there is no tangent plane).
struct NodeOrder {
  std::vector<Vector3d> normals;
  std::vector<std::vector<EdgeEnd>> around;
  std::vector<std::vector<double>> angles;  // rad, from each of these to the next: 2π at a node
};

// At each node that direction along which its edges are seen furthest from one another; of its two
// senses that which agrees with the neighbours', brought along edges without turning about them
// (Wang, Jüttler, Zheng & Liu 2008: double reflections), the surest first; for the whole that which
// points away from the middle of the network's upper end: in the centre plane, where all is to port
// of it. Edges that leave a node within a degree of one another are told apart by their chords.
//
// REQUIRES: connected edges.
NodeOrder node_order(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes);

// A direction brought along an edge from its one end to its other.
Vector3d carried_along(const EdgeShape& shape, bool from_start, const Vector3d& direction);

}  // namespace hull::network

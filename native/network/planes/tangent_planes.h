// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/vectors.h"

namespace hull::network {

// What a node's tangent planes are found from: the ends of edges around it, counterclockwise seen
// from outside, and the sectors between each end and the next one.
struct NodeStar {
  std::vector<Vector3d> directions;  // unit, from the node
  std::vector<int> curves;           // of the ends
  std::vector<bool> is_crease;       // ends along which the surface is known to have a knuckle
  std::vector<bool> is_beyond;       // sectors in which there is no surface
  Vector3d outwards;                 // roughly
};

struct TangentPlanes {
  std::vector<Vector3d> normals;  // of the sectors, unit, outwards; zero of those beyond
  std::vector<bool> is_told;      // of the sectors: whether edges span the plane
  std::vector<bool> is_crease;    // of the ends: known, or found
  double deviation = 0.0;         // rad: the most that an edge is off the plane of its sectors
  bool has_planes = true;         // else each sector has one of its own
};

// Edges that go on in one another within 15° span no plane by themselves: theirs is across what is
// seen from outside, and not told.
//
// One plane for all sectors between creases and beyond-sectors, by least squares, where edges are
// within `limit`, rad, of it. Where they are not the creases are looked for: along one of the
// curves there, or two where one will not do, such that all planes are within the limit, and the
// deviation is least. Where there are none, each sector is a plane by itself, between the two edges
// that bound it, and that is told: no mean of planes is taken.
TangentPlanes tangent_planes(const NodeStar& star, double limit);

}  // namespace hull::network

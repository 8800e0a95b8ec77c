// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/topology.h"
#include "morphing/orientation.h"

namespace hull::morphing {

// Triangles of the plane that all turn to the left and cover a disc. The border may be a chain of
// other points along its edges: nothing is asked of these edges' lines.
struct PlaneMesh {
  const mesh::Topology* topology;
  const std::vector<Vector2d>* places;
};

// Where a point is in such a mesh: on a point, within an edge (one of its half-edges), or within a
// triangle.
enum class Within { kPoint, kEdge, kTriangle };
struct Location {
  Within within;
  int index;
};

// A stretch of a straight walk: through a triangle, or along an edge, to where it meets the next
// point or edge, or ends.
struct Stretch {
  int triangle;   // -1 along an edge
  int half_edge;  // in the walk's direction; -1 through a triangle
  Location end;   // never within a triangle but at the end of the walk
};

// Appends the stretches of the straight line from place p, which is at `from`, to place q. All
// decisions are signs of orientation(), and so exact. Where q is on the border, `end` tells where,
// for its edges are not asked; else it is null.
//
// REQUIRES: p and q differ, and all but the ends of the walk is within the border.
void walk(const PlaneMesh& ground, const Location& from, const Vector2d& p, const Vector2d& q,
          const Location* end, std::vector<Stretch>& stretches);

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "morphing/parametrisation/triangle_disc.h"

namespace hull::morphing {

// A border point of a disc on one of its sides, stretches of the border from corner to corner.
struct BorderPoint {
  int point;
  int half_edge;  // along the border, from the point
  int side;       // that begins here, or has the point within it
  double along;   // length from the side's beginning, by the side's length
};

// All border points in order, from the first corner, with chord lengths along each side.
//
// `corners`: border points in the order of the border, which has the surface to its left; three or
// more. Throws std::invalid_argument, naming the corner, for others; and, naming it, for a border
// edge of less than 1e-8 of its side.
std::vector<BorderPoint> border_points(const TriangleDisc& disc, const std::vector<int>& corners);

// Of each side, m.
std::vector<double> side_lengths(const TriangleDisc& disc, const std::vector<int>& corners);

// A disc in which no inner edge joins two points of one side: it would be laid onto the side, and
// triangles would lose their area.
struct SplitDisc {
  TriangleDisc disc;
  // The edge in whose middle each new point is; those come after the old ones.
  std::vector<std::array<int, 2>> split_edges;
};

// Divides such edges, and the triangles at them, in the middle; points and corners as above.
SplitDisc split_chords(const TriangleDisc& disc, const std::vector<int>& corners);

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawing/lines_plan/lines_drawing.h"

namespace hull::drawing {

// The box in ship axes that every view shows, in metres; breadth is measured from the centre plane.
struct HullExtents {
  double aft, fore;
  double breadth;
  double bottom, top;
  double midship;
  double diagonals;  // reach of the expanded diagonals from the centre line; 0 without
};

// The extents of all curves, with the base line and the perpendiculars where they are near the
// hull. Throws as lay_out_lines.
HullExtents hull_extents(const LinesDrawing& drawing);

// The distance of a point in a diagonal's plane from the centre line, along the plane.
double expanded(const Diagonal& diagonal, const Eigen::Vector3d& point);

}  // namespace hull::drawing

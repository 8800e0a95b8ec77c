// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/immersion/hull_body.h"
#include "surface/progress.h"

namespace hull::production {

// Triangles that enclose a body: every side belongs to two of them, which run through it in
// opposite directions. Corners run counter-clockwise seen from outside.
struct ClosedModel {
  std::vector<Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  // By triangle: the surface's cell that it is of, its mirror image counting as it; -1 on closings.
  // None where it is not known.
  std::vector<int> cells;

  double volume() const;
  double area() const;
};

// The whole body with its closings, both sides. Every point of the shell is within
// `chord_tolerance`, m, of the triangles, so that the volume is within that times the area of the
// exact one. Closings are straight lines between points of the border.
//
// Throws std::invalid_argument as surface::chord_divisions_for(), where faces are turned inwards,
// and where an opening can't be closed so.
ClosedModel closed_model(const analysis::HullBody& body, double chord_tolerance,
                         const surface::Progress& progress = {});

// All lengths times `factor`, in single precision as most files have them; triangles that vanish
// by this are left out together with the side that they had in common, so that the model stays
// closed. Throws std::invalid_argument unless the factor is positive and finite, where points
// would not be finite in that precision, and if nothing is left.
ClosedModel scaled(const ClosedModel& model, double factor);

// Leaves out points that no triangle has.
void drop_unused_points(ClosedModel& model);

// How many sides do not belong to just two triangles, run through in opposite directions.
int open_sides(const ClosedModel& model);

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/sections/border_edges.h"

namespace hull::analysis {

// The piece of a closing surface at one edge of a border.
struct ClosingPatch {
  int cell;                        // at whose side it is
  surface::BicubicPoints cap;      // as a bicubic span, normal outwards
  std::array<Vector3d, 4> border;  // Bézier points of the border curve that it closes from
  bool open;  // whether water could flow in here, if the opening is not declared closed
};

// What closes a surface to a body, its border given as border_edges() has it. It is closed
//   by straight athwartships lines to the centre plane, or to a plane parallel to it, where that
//   makes a closed body: at borders that meet the centre plane of a half hull (`mirrored`), and at
//   loops whose projection on the centre plane has no area, as those of symmetric bodies have;
//   by the fan from its centroid to its curve elsewhere. For plane loops both are the plane.
// The closing of a whole hull is that of its half.
//
// Borders in the centre plane of a half hull are no openings. Closings in planes across the ship,
// open transoms and the ends of cut bodies, are taken for closed; all others are open.
std::vector<ClosingPatch> closing_patches(const surface::LimitSurface& surface,
                                          const std::vector<BorderEdge>& border, bool mirrored);

// The lowest point at which water can flow in.
struct DownfloodingPoint {
  double height;  // along the direction asked for, m; infinite if there is none
  Vector3d point;
};

// The lowest point of a Bézier cubic along `up`.
DownfloodingPoint lowest_point(const std::array<Vector3d, 4>& cubic, const Vector3d& up);

}  // namespace hull::analysis

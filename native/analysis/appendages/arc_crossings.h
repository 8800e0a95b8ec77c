// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/pieces/bezier_patch.h"

namespace hull::analysis {

// A cubic by its Bézier points, parameter t in [0, 1].
using CubicArc = std::array<Vector3d, 4>;

Vector3d arc_point(const CubicArc& arc, double t);

// Where an arc passes through a patch.
struct ArcCrossing {
  double t;
  // Of the patch's outward side, S_u x S_v, with the arc's direction: 1 if the arc goes out there,
  // -1 if it comes in, 0 where it only touches, or where that is not known.
  int way;
};

// Two planes through a line along an arc, on which the arc's own extent is small: what both parts'
// shadows on them share is looked at further.
struct ArcFrame {
  Vector3d first, second;
  explicit ArcFrame(const CubicArc& arc);
};

// Appends all crossings of the arc and the patch. Parts are left out where control points prove
// them apart; one root is taken for a part's only one where bounds of the derivatives prove that;
// others are halved. Where an arc touches a patch, or runs along it, halving ends at `touching`
// (m), or after two thousand parts, and what is left counts as a crossing with way 0. Returns how
// many parts were looked at.
int find_arc_crossings(const CubicArc& arc, const ArcFrame& frame,
                       const surface::BezierPatch& patch, double touching,
                       std::vector<ArcCrossing>& crossings);

}  // namespace hull::analysis

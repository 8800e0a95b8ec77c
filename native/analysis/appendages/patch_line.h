// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/appendages/arc_crossings.h"
#include "analysis/immersion/shell_moments.h"

namespace hull::analysis {

// The line u -> S(u, v) of a patch, and S_v along it.
struct PatchLine {
  CubicArc arc, across;

  PatchLine(const surface::BezierPatch& patch, double v);
  Vector3d point(double u) const { return arc_point(arc, u); }
  Vector3d normal(double u) const;  // S_u x S_v
};

// Gauss' rule along lines: exact up to degree 15, of which 11 is needed.
constexpr int kLineNodes = 8;

// Adds the moments about an origin of a stretch of a line, as wide across as `weight` of the patch.
void add_stretch(const PatchLine& line, const Vector3d& origin, double begin, double size,
                 double weight, ShellMoments& sum);

// A side of a patch: from a control point on, in steps of so many.
CubicArc side_arc(const surface::BezierPatch& patch, int first, int step);

surface::BezierPatch transposed(const surface::BezierPatch& patch);

}  // namespace hull::analysis

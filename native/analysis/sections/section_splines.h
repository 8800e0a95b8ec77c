// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/sections.h"
#include "surface/creases/cubic_spline.h"

namespace hull::analysis {

// A stretch of a section between knuckles as a cubic B-spline curve: twice continuously
// differentiable, knots rising from 0 to about the arc length in m, the first and last of them
// fourfold, so that it starts and ends in its first and last control points. Control points lie in
// the section's plane to rounding.
struct SectionSpline {
  surface::CubicSpline curve;
  // The stretch is a whole closed curve without knuckles; the spline's derivatives agree there,
  // too.
  bool closed;
  double largest_distance;  // from the section, m, where it was measured: at most the tolerance
};

// The splines of one branch of a section, in order.
struct SectionSplines {
  std::vector<SectionSpline> splines;
  bool closed;  // the branch: the last spline ends where the first starts
};

// The section by a plane as splines no further than `tolerance` (m) from it. Distances are measured
// at points closer than the spline's knots, and between them along cubics that follow the section's
// exact tangents. A stretch that does not come so near to a spline with a knot in each of them (at
// irregular knots, where the section's curvature may diverge) gets the spline of all these knots.
//
// What belongs to the section, and the direction of running, are as in section(). Throws
// std::invalid_argument as section() does, `tolerance` in the place of its chord tolerance.
std::vector<SectionSplines> section_splines(const surface::LimitSurface& surface,
                                            const Plane& plane, double tolerance,
                                            std::optional<double> flat_tolerance = {});

}  // namespace hull::analysis

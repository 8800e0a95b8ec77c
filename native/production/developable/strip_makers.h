// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/developable/developable_strip.h"

namespace hull::production {

// Two curves with the strip between them.
struct StripBetween {
  BezierChain a, b;
  DevelopableStrip strip;
};

// The cone of straight lines from a curve to its tip: b is that point alone, t is 0 on all rulings,
// and so the first is the only one of the strip's core. `count` intervals as of
// developable_strip(). Throws std::invalid_argument for a tip that is not finite, for one on the
// curve, and for counts as developable_strip().
StripBetween cone_through(const BezierChain& a, const Vector3d& tip, int count);

// The cylinder from a curve along a direction, `length` (m) of it: rulings join equal parameters.
// Throws std::invalid_argument for a direction without length, for a length that is not positive,
// where the curve runs along the direction, and for counts as developable_strip().
StripBetween cylinder_along(const BezierChain& a, const Vector3d& direction, double length,
                            int count);

// A line on a strip: where rulings meet what is projected onto it.
struct StripLine {
  std::vector<int> rulings;   // that follow one another …
  std::vector<double> along;  // … and where on each, 0 at a's end and 1 at b's
};

// A polyline projected onto a strip along a direction: of each ruling the point at which rays from
// the polyline meet it, of several the one nearest to the polyline. Rays go on through the strip:
// one that bends round has the line on both sides. A line for each sequence of rulings that are met
// one after another; it ends on the last ruling, not on the polyline's own end.
//
// Throws std::invalid_argument for fewer than two points, for numbers that are not finite, a
// direction without length, and where fewer than two rulings that follow one another are met.
std::vector<StripLine> projected_on(const StripBetween& strip, const std::vector<Vector3d>& points,
                                    const Vector3d& direction);

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/developable/bezier_chain.h"

namespace hull::production {

// A straight line from a(s) to b(t), of the surface between two curves.
struct Ruling {
  double s, t;
};

// The developable surface between two curves: lines along each of which one plane touches both,
// (a(s) - b(t)) · (a'(s) x b'(t)) = 0 (Koelman 1999, 5.4.3.1), closed at its ends by cones with
// their tips in ends of the curves. Along the rulings s and t do not fall, from (0, 0) to the ends.
struct DevelopableStrip {
  std::vector<Ruling> rulings;
  int first, last;  // rulings [first, last] are of the first kind, those before and behind of cones
};

inline constexpr int kMostRulings = 5000;
// Throws std::invalid_argument for counts below 1 and above kMostRulings.
void check_interval_count(int count);

// `count` intervals along the first curve, or some more, so that its joints are among their ends.
// Where several lines fit, those are taken that rise with one another over the longest part of the
// first curve. Throws std::invalid_argument for counts below 1 and above kMostRulings, and where
// no such line is found.
DevelopableStrip developable_strip(const BezierChain& a, const BezierChain& b, int count);

// The ends of the strip's rulings laid out in the plane, at a's and at b's, the first curve to the
// right: lengths, areas and geodesic curvatures are those of the strip, up to the fourth power of
// the rulings' distance.
struct DevelopedStrip {
  std::vector<Eigen::Vector2d> a, b;
};

// REQUIRES: the strip is developable_strip(a, b, ...), or of strip_makers.h.
DevelopedStrip developed(const BezierChain& a, const BezierChain& b, const DevelopableStrip& strip);

// All t at which a line from a(s) to b(t) has one tangent plane, rising.
std::vector<double> touching(const BezierChain& a, double s, const BezierChain& b);

}  // namespace hull::production

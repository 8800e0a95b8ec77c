// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/arithmetic/bezier_net.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// A square of a piece in which the surface crosses a plane, at most once for each u: there two
// coordinates a and b are functions of u.
struct ArcSquare {
  BezierNet h, a, b;  // height above the plane and the coordinates
  double sign;        // +1 if the section runs towards larger u, for whom that matters
};

struct ArcPoint {
  double a, b, da, db;  // derivatives along u
  double v;
};

// REQUIRES: u lies in a stretch of the square.
ArcPoint arc_point(const ArcSquare& square, double u);

// Whether b rises or falls all along: the sign of h_u b_v - h_v b_u, bounded by the slopes, is the
// same in the whole square.
bool is_monotonic(const ArcSquare& square);

// Calls visit(begin, end) for the stretches of u on which the surface crosses the plane.
template <class Visit>
void for_each_stretch(const ArcSquare& square, const Visit& visit) {
  const auto breaks = crossing_breaks(BezierBicubic(square.h));
  const double* previous = nullptr;
  for (const double& next : breaks) {
    if (previous && next > *previous) {
      const Column column(square.h, BernsteinBasis(0.5 * (*previous + next)));
      // Between two breaks it crosses for all u or for none.
      if ((column.c[0] < 0.0) != (column.c[3] < 0.0)) visit(*previous, next);
    }
    previous = &next;
  }
}

}  // namespace hull::analysis

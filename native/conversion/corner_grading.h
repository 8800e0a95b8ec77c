// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/square_fan.h"

namespace hull {

// What the corner squares at an irregular point must keep.
struct CornerLimits {
  double distance = 0.0;  // metres, from the surface
  double angle = 0.0;     // radians, between normals at smooth seams; does not count where the
                          // squares are smaller than the distance
};

// A fan whose seams are fitted where that is of use, and how large its errors are, as shares of the
// limits.
struct GradedFan {
  Grading grading;
  SquareFan fan;
  double excess = 0.0;
};

GradedFan graded_fan(const LimitSurface& surface, int vertex, const Grading& grading,
                     const CornerLimits& limits);

// The fan with a grading from `first` to `last` halvings, as few as can be foretold, that keeps the
// limits. Where none does, the last one that was of use.
GradedFan least_graded_fan(const LimitSurface& surface, int vertex, const CornerLimits& limits,
                           const Grading& first, int last);

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/exact/square_fan.h"

namespace hull::conversion {

// How many points of the corner squares around an irregular point are moved together at most, by
// fits whose time grows with the cube of that.
inline constexpr int kMostMoved = 96;

// Of a fan of so many squares.
inline int moved_points(int squares, int inner) { return squares * inner * (inner + 1); }

// What the corner squares at an irregular point must keep.
struct CornerLimits {
  double distance = 0.0;  // metres, from the surface
  double angle = 0.0;     // radians, between normals at smooth seams; does not count at cones' tips
                          // nor where the squares are smaller than the distance
};

// A fan whose seams are fitted where that is of use and can be done.
struct GradedFan {
  Grading grading;
  SquareFan fan;
  double distance = 0.0, angle = 0.0;  // its errors, as shares of the limits
  // The larger of the same for fitted seams, where they took the squares so far off the surface
  // that they were left as they were: what more halvings are foretold by.
  double outlook = 0.0;

  double excess() const { return distance > angle ? distance : angle; }
  // Whether an error is clearly smaller: the distance as long as it is too large.
  bool is_better_than(const GradedFan& other) const;
};

GradedFan graded_fan(const surface::LimitSurface& surface, int vertex, const Grading& grading,
                     const CornerLimits& limits);

// The fan with a grading from `first` to `last` halvings, as few as can be foretold, that keeps the
// limits. Where none does, the last one that was of use.
GradedFan least_graded_fan(const surface::LimitSurface& surface, int vertex,
                           const CornerLimits& limits, const Grading& first, int last);

}  // namespace hull::conversion

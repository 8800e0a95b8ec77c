// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/crossings/curve_tree.h"

namespace hull::network {

// Where two curves come near one another: parameters, and the places on either.
struct CurveMeeting {
  double first, second;
  Vector3d first_place, second_place;

  double distance() const { return (first_place - second_place).norm(); }
};

// A stretch along which they stay near one another: from parameters to parameters; those of the
// second curve fall where it runs the other way.
struct CurveOverlap {
  double first_low, first_high;
  double second_low, second_high;
  double length;  // m, along the first one
  Vector3d start, end;
};

struct CurveMeetings {
  std::vector<CurveMeeting> points;  // by the first curve's parameter
  std::vector<CurveOverlap> overlaps;
};

// √(8 reach size), size being the lesser curve's: how long two curves whose curvatures differ by
// 1 / size are within a reach of one another where they touch.
double longest_touch(const CurveTree& first, const CurveTree& second, double reach);

// All places where two curves are within `reach`, m, of one another: each coherent stretch gives
// the pair of points that are nearest (the crossing, to rounding, where they cross; an end of a
// curve where that is nearest), or an overlap, where it is longer than longest_touch().
// Nothing is missed but what the trees' flatness hides: approaches between reach and reach + 2 flat
// may or may not be told.
CurveMeetings curve_meetings(CurveTree& first, CurveTree& second, double reach);

}  // namespace hull::network

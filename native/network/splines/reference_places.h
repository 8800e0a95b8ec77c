// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patches/bspline_curve.h"
#include "network/patches/region_sides.h"

namespace hull::network {

// Where in the unit square of a patch of four sides references run. Nodes on the sides are where
// the sides have them; those inside are where, in the mean of squares, each divides the way between
// its neighbours along a curve as it does the curve's parameter, so that curves which cross like
// parameter lines of a patch are straight lines; where curves only end it is the mean of its
// neighbours, by the inverse of how far along the curves they are. Along a curve places are a cubic
// spline through those of its nodes, by its parameter.
class ReferencePlaces {
 public:
  // `sides`: four, counterclockwise, side 0 from (0, 0) to (1, 0). `references`: edges inside.
  ReferencePlaces(const NetworkFrame& frame, const std::vector<RegionSide>& sides,
                  const std::vector<int>& references);

  // Of a reference, by its number among them, at a parameter of its edge.
  Vector2d at(std::size_t reference, double t) const;

 private:
  struct Part {
    std::size_t chain;
    double low, high;  // of the chain's parameter
  };
  std::vector<conversion::BSplineCurve> chains_;  // in the plane z = 0
  std::vector<Part> parts_;                       // of references
};

}  // namespace hull::network

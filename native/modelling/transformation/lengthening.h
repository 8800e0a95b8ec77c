// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modelling/transformation/longitudinal_reshape.h"
#include "modelling/transformation/shift_functions.h"

namespace hull::modelling {

// A hull that became longer, or shorter.
struct Lengthened {
  std::vector<Vector3d> moves;  // of all control points, along x, m
  HullRange range;              // between whose ends the hull was stretched, x, m
  bool is_parallel;             // the immersed body is parallel there: ∇ grew by area x length
  double area;                  // m², of the immersed section at the place
  double volume_change;         // m³, of the resulting surface
  double rms, largest;          // of the wanted shifts less what the surface does, m; 0 if parallel
};

// Inserts a length of parallel middle body at the section x = place, m, or takes it out where the
// length is negative: what is ahead of the parallel body moves as one, what is abaft stays, and
// control points between move in proportion. As sections there are all the same, the displacement
// grows by exactly their area times the length. That only what is immersed is the same is enough:
// above the water a sheer is stretched.
//
// With `stretched` the shift goes smoothly from zero at its aft end to the length at its forward
// one, whatever the body there; control points of what lies outside move as one or not at all.
//
// Throws std::invalid_argument where the body is not parallel, or in too few rows of control
// points, and nothing is stretched; where what is taken out is longer than what there is; and where
// locked points would have to move.
Lengthened lengthen(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                    double place, double length, const std::optional<HullRange>& stretched,
                    const TransformLimits& limits);

}  // namespace hull::modelling

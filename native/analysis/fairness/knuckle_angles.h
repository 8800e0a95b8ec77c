// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// The angle along a knuckle (Greshake 2021, 5.1: the angle between the normals of an angle curve),
// in radians, by surface/creases/knuckle_angle.h.
struct KnuckleAngles {
  std::vector<double> t;            // of the curve
  std::vector<double> arc_lengths;  // over the edges measured, from the first of them, m
  std::vector<double> angles;       // NaN where there is none
  double length;                    // of the edges measured, m
  double least, mean, largest;      // mean by arc length; NaN where no sample has an angle
};

// Along the control edges of the curve that are named, rising, or along all: samples_per_edge even
// steps of t on each edge, and its end. An edge that does not follow the one before it starts with
// a sample of its own. Arc lengths are right to about 1e-6.
//
// Throws std::invalid_argument for a border, which has a surface on one side only, for edges that
// the curve does not have or that do not rise, or fewer than 1 or more than 1000 samples.
KnuckleAngles knuckle_angles(const surface::LimitSurface& surface,
                             const surface::CreaseCurve& curve, const std::vector<int>& edges = {},
                             int samples_per_edge = 8);

}  // namespace hull::analysis

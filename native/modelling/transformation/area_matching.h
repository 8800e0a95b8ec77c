// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "modelling/transformation/inflation.h"
#include "modelling/transformation/shift_functions.h"
#include "modelling/transformation/target_curve.h"

namespace hull::modelling {

// How sections come to the areas that are wanted: each is moved along the ship to where its area is
// wanted (Lackenby 1950), or inflated where it is.
enum class AreaMatching { kShift, kInflate };

// A hull with another sectional area curve.
struct AreasMatched {
  std::vector<Vector3d> moves;  // of all control points, m
  // The largest difference of areas, in parts of the largest area wanted, and its x, m; as it was
  // and as it came to be.
  double difference_before, difference, difference_at;
  double rms, largest;     // of the wanted shifts less what the surface does, m
  Vector3d largest_place;  // where on the surface as it was
  double volume, lcb;      // of the resulting surface: m³, x in m
  int iterations;
  bool converged;  // the difference is below the tolerance; else its root mean square is the least
};

// Brings the sectional area curve to a wanted one: stations are cut, shifted or inflated by what
// their exact areas lack, and cut again, until the largest difference at places all along both
// curves is below `tolerance`, in parts of the largest area wanted, or their root mean square falls
// no further.
//
// By shifts, areas are compared in parts of the largest of each curve: they leave the largest
// section as it is. Throws std::invalid_argument where sections would have to overtake one another
// or the surface fold at once.
AreasMatched match_areas(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                         const TargetCurve& target, AreaMatching how, double tolerance,
                         const TransformLimits& limits);

}  // namespace hull::modelling

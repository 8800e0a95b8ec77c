// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/fairness/measured_curve.h"

namespace hull::analysis {

// What of a curve's bending counts.
struct CurvatureNoise {
  double absolute;  // 1/m
  double relative;  // to the curvature below which 95 % of the curve's length bend
};

struct CurveMark {
  // An inflection, or a maximum or minimum of the signed curvature.
  enum class Kind { kInflection, kMaximum, kMinimum } kind;
  double arc_length;
  Vector3d point;
  double curvature;  // signed, 1/m; of an inflection 0
  bool peak;         // a place where the curve bends more than to both sides
};

// Inflections and extrema of the signed curvature along a curve, in order.
//
// The threshold is the larger of the two noises. An inflection lies between two places that bend to
// different sides by more than it.
// An extremum differs by more than the threshold from what the curvature falls (or rises) to on
// either side before it comes as far again. So straight parts have none, however they tremble. Ends
// of open curves are no extrema.
//
// Both are looked for between two to four places to each of the curve's breaks, the more the longer
// it is, so that what comes and goes within less is not found; and then refined on the curve
// itself, inflections to 1e-10 of its length, extrema to 1e-6 (a curvature hardly changes beside
// its extremum). Where a curve is straight between two bends an inflection is somewhere on the
// straight part.
std::vector<CurveMark> curve_marks(MeasuredCurve& curve, const CurvatureNoise& noise);

}  // namespace hull::analysis

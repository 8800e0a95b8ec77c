// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "conversion/patches/bspline_curve.h"
#include "network/curves/nurbs_curve.h"

namespace hull::network {

using conversion::BSplineCurve;

// The point and the slope of a curve over 0 … 1, a row each.
using CurveFunction = std::function<Points3(double)>;

struct FittedSpline {
  BSplineCurve curve;
  double error = 0.0;  // m: the furthest from the curve's points at equal parameters, of samples
};

// Where spans begin and end, from 0 to 1, and a curve's points there.
struct SplineBreaks {
  std::vector<double> at;
  std::vector<Vector3d> places;

  std::size_t spans() const { return at.size() - 1; }
  double width(std::size_t span) const { return at[span + 1] - at[span]; }
};

// The cubic spline through points with slopes at both ends (the complete spline).
BSplineCurve complete_spline(const SplineBreaks& breaks, const Vector3d& start_slope,
                             const Vector3d& end_slope);

// A curve as a cubic spline that has its points at its knots and its slopes at both ends (the
// complete spline). Spans that are not within `tolerance`, m, of the curve are halved, down to
// 2^-12 of the whole, while there are no more than 128; polynomials up to the third degree are met
// with one.
FittedSpline fitted_spline(const CurveFunction& curve, double tolerance);

// The point and the slope at t, which is within [0, 1].
Points3 spline_jet(const BSplineCurve& curve, double t);

// The same curve over other knots, among which are its own but for rounding.
BSplineCurve with_knots(const BSplineCurve& curve, const std::vector<double>& knots);

// Knots of both, each as often as where it is there oftener; those that differ by rounding are one.
std::vector<double> united_knots(const std::vector<double>& one, const std::vector<double>& other);

// Clamped, with `spans` equal ones.
std::vector<double> uniform_knots(int spans);

// Curves that follow one another as one over `ends`, which rise from 0 to 1: where slopes agree but
// for rounding the knot is a double one, else a threefold one.
BSplineCurve strung_together(const std::vector<BSplineCurve>& parts,
                             const std::vector<double>& ends);

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/fitted_spline.h"

#include <algorithm>
#include <cmath>

#include "conversion/patches/bspline_patch.h"

namespace hull::network {
namespace {

constexpr std::size_t kMostSpans = 128;
constexpr double kLeastSpan = 0x1p-12;
constexpr int kTestsOfSpan = 4;
constexpr double kSameSlope = 1e-9;  // of a spline's size
constexpr double kRounding = 2e-14;  // of it

double furthest_in(const BSplineCurve& spline, const CurveFunction& curve, double low,
                   double width) {
  double error = 0.0;
  for (int i = 0; i < kTestsOfSpan; ++i) {
    // Between knots: at these the spline has the curve's points.
    const double t = low + width * (i + 0.5) / kTestsOfSpan;
    error = std::max(error, (spline.position(t) - Vector3d(curve(t).row(0))).norm());
  }
  return error;
}

// With the spans halved that are to be; false where none may be.
bool halve(SplineBreaks& breaks, const std::vector<bool>& is_off, const CurveFunction& curve) {
  SplineBreaks halved{{0.0}, {breaks.places.front()}};
  for (std::size_t s = 0; s < breaks.spans(); ++s) {
    if (is_off[s] && breaks.width(s) > kLeastSpan) {
      halved.at.push_back(0.5 * (breaks.at[s] + breaks.at[s + 1]));
      halved.places.emplace_back(curve(halved.at.back()).row(0));
    }
    halved.at.push_back(breaks.at[s + 1]);
    halved.places.push_back(breaks.places[s + 1]);
  }
  if (halved.spans() == breaks.spans() || halved.spans() > kMostSpans) return false;
  breaks = std::move(halved);
  return true;
}

// Without one of a double knot, where the curve is as smooth as with a simple one but for rounding
// (the knot's second insertion, undone from both sides).
void make_simple(BSplineCurve& curve, double t, double rounding) {
  auto& knots = curve.knots;
  const auto s =
      static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), t) - knots.begin());
  // Of the knots with t once: those around it.
  const double before = knots[s - 1], second_before = knots[s - 2], after = knots[s + 2],
               second_after = knots[s + 3];
  const double low = (t - second_before) / (after - second_before);
  const double high = (t - before) / (second_after - before);
  auto& points = curve.points;
  // The control point from which the second knot's insertion made two, from its left and its right.
  const Vector3d one = (points[s - 2] - (1.0 - low) * points[s - 3]) / low;
  const Vector3d other = (points[s - 1] - high * points[s]) / (1.0 - high);
  // By so much the second point would be off, were the knot put in again.
  if (!((1.0 - high) * (one - other).norm() <= rounding)) return;
  points[s - 2] = one;
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(s) - 1);
  knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(s));
}

}  // namespace

std::vector<double> uniform_knots(int spans) {
  return conversion::open_uniform_knots(3, spans + 3);
}

// The inner control points have the curve's points at inner knots: one row of three functions each,
// but beside the ends, solved from both sides inwards (Thomas).
BSplineCurve complete_spline(const SplineBreaks& breaks, const Vector3d& start_slope,
                             const Vector3d& end_slope) {
  BSplineCurve curve{3, std::vector<double>(3, 0.0), {}};
  curve.knots.insert(curve.knots.end(), breaks.at.begin(), breaks.at.end());
  curve.knots.insert(curve.knots.end(), 3, 1.0);
  auto& points = curve.points;
  points.resize(breaks.spans() + 3);
  points.front() = breaks.places.front();
  points.back() = breaks.places.back();
  // A clamped cubic begins along its first leg, three times it over the first span.
  points[1] = points.front() + start_slope * (breaks.width(0) / 3.0);
  points[points.size() - 2] = points.back() - end_slope * (breaks.width(breaks.spans() - 1) / 3.0);
  const std::size_t first = 2, last = breaks.spans();
  // Of each row, after the one before is taken off it, what is left of the next point.
  std::vector<double> above(points.size(), 0.0);
  for (std::size_t i = first; i <= last; ++i) {
    const conversion::BasisValues values =
        conversion::basis_values(curve.knots, 3, curve.knots[i + 2]);
    // At a simple knot three functions are left; the fourth begins there.
    const auto row = values.rows.row(0);
    const double pivot = row(1) - row(0) * above[i - 1];
    Vector3d right = breaks.places[i - 1] - row(0) * points[i - 1];
    // The last but one point is known, by the slope.
    if (i == last) right -= row(2) * points[i + 1];
    above[i] = i == last ? 0.0 : row(2) / pivot;
    points[i] = right / pivot;
  }
  for (std::size_t i = last; i-- > first;) points[i] -= above[i] * points[i + 1];
  return curve;
}

FittedSpline fitted_spline(const CurveFunction& curve, double tolerance) {
  const Points3 start = curve(0.0), end = curve(1.0);
  SplineBreaks breaks{{0.0, 1.0}, {start.row(0), end.row(0)}};
  while (true) {
    FittedSpline fitted{complete_spline(breaks, start.row(1), end.row(1))};
    // Which spans to halve is told by themselves, not by the worst of all.
    std::vector<bool> is_off(breaks.spans());
    for (std::size_t s = 0; s < breaks.spans(); ++s) {
      // All spans each time: one that is halved moves its neighbours, too.
      const double error = furthest_in(fitted.curve, curve, breaks.at[s], breaks.width(s));
      is_off[s] = error > tolerance;
      fitted.error = std::max(fitted.error, error);
    }
    if (fitted.error <= tolerance || !halve(breaks, is_off, curve)) return fitted;
  }
}

Points3 spline_jet(const BSplineCurve& curve, double t) {
  const conversion::BasisValues values = conversion::basis_values(curve.knots, curve.degree, t);
  Points3 jet = Points3::Zero(2, 3);
  for (int i = 0; i <= curve.degree; ++i) {
    const Vector3d& point = curve.points[static_cast<std::size_t>(values.first + i)];
    for (int k = 0; k < 2; ++k) jet.row(k) += values.rows(k, i) * point.transpose();
  }
  return jet;
}

BSplineCurve with_knots(const BSplineCurve& curve, const std::vector<double>& knots) {
  BSplineCurve result = curve;
  for (double& knot : result.knots) {
    // First to the others' digits: knots that differ by rounding would come twice, else.
    const auto near = std::lower_bound(knots.begin(), knots.end(), knot - conversion::kSameKnot);
    if (near != knots.end() && *near <= knot + conversion::kSameKnot) knot = *near;
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    // From the first on, so that both lists agree up to here.
    if (i >= result.knots.size() || result.knots[i] != knots[i]) result.insert_knot(knots[i]);
  }
  return result;
}

std::vector<double> united_knots(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> all;
  std::size_t i = 0, k = 0;
  while (i < one.size() && k < other.size()) {
    if (std::abs(one[i] - other[k]) <= conversion::kSameKnot) {
      all.push_back(one[i]);
      ++i, ++k;
    } else {
      all.push_back(one[i] < other[k] ? one[i++] : other[k++]);
    }
  }
  // Both end in the same clamped end.
  return all;
}

BSplineCurve strung_together(const std::vector<BSplineCurve>& parts,
                             const std::vector<double>& ends) {
  if (parts.size() == 1) return parts.front();
  BSplineCurve whole{3, std::vector<double>(4, 0.0), parts.front().points};
  double size = 0.0;
  for (const BSplineCurve& part : parts) size += part.polygon_length();
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const BSplineCurve& part = parts[p];
    const double width = ends[p + 1] - ends[p];
    if (p > 0) {
      // Slopes by the whole's parameter.
      const Vector3d before = spline_jet(parts[p - 1], 1.0).row(1) / (ends[p] - ends[p - 1]);
      const Vector3d after = spline_jet(part, 0.0).row(1) / width;
      const bool is_smooth = (before - after).norm() <= kSameSlope * size;
      // At a double knot the common point lies between its neighbours, and is none of the spline's
      // own.
      if (is_smooth) whole.points.pop_back();
      whole.knots.insert(whole.knots.end(), is_smooth ? 2 : 3, ends[p]);
      whole.points.insert(whole.points.end(), part.points.begin() + 1, part.points.end());
    }
    for (std::size_t i = 4; i + 4 < part.knots.size(); ++i) {
      whole.knots.push_back(ends[p] + width * part.knots[i]);
    }
  }
  whole.knots.insert(whole.knots.end(), 4, 1.0);
  for (std::size_t p = 1; p < parts.size(); ++p) {
    // Where the second derivative goes on, too, as from edge to edge of one curve, one knot will
    // do.
    if (std::ranges::count(whole.knots, ends[p]) == 2) {
      make_simple(whole, ends[p], kRounding * size);
    }
  }
  return whole;
}

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/bspline_curve.h"

#include <algorithm>
#include <utility>

#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {
namespace {

// The knot at t but for the rounding of reversed knots, otherwise t itself.
double snapped(const std::vector<double>& knots, double t) {
  constexpr double kRounding = 1e-14;
  const auto near = std::lower_bound(knots.begin(), knots.end(), t - kRounding);
  return near != knots.end() && *near <= t + kRounding ? *near : t;
}

// Inserts the knot t once more, which there is `times` times (Boehm 1980).
void insert(BSplineCurve& curve, double t, long times) {
  const std::vector<double>& knots = curve.knots;
  const auto after = std::upper_bound(knots.begin(), knots.end(), t);
  // Only functions that live at t change: points before them stay, those after move up by one, and
  // those between are de Boor's first step at t.
  const int span = static_cast<int>(after - knots.begin()) - 1;
  std::vector<Vector3d> points;
  for (int i = 0; i <= static_cast<int>(curve.points.size()); ++i) {
    if (i <= span - curve.degree) {
      points.push_back(curve.points[i]);
    } else if (i > span - times) {
      points.push_back(curve.points[i - 1]);
    } else {
      const double share = (t - knots[i]) / (knots[i + curve.degree] - knots[i]);
      points.push_back((1.0 - share) * curve.points[i - 1] + share * curve.points[i]);
    }
  }
  curve.points = std::move(points);
  curve.knots.insert(curve.knots.begin() + span + 1, t);
}

// Inserts a knot until it has the multiplicity of the degree, so that the curve passes through a
// control point there.
void saturate(BSplineCurve& curve, double t) {
  for (auto times = std::ranges::count(curve.knots, t); times < curve.degree; ++times) {
    insert(curve, t, times);
  }
}

// Over [0, 1] the part between two knots that the curve passes through control points at.
BSplineCurve between(const BSplineCurve& whole, double begin, double end) {
  const int degree = whole.degree;
  const auto inner = std::upper_bound(whole.knots.begin(), whole.knots.end(), begin);
  const auto outer = std::lower_bound(inner, whole.knots.end(), end);
  // The number of the point met at `begin`, where there are as many knots as the degree, or one
  // more at the curve's own end.
  const auto first = inner - whole.knots.begin() - degree - 1;
  BSplineCurve result{degree, std::vector<double>(degree + 1, 0.0), {}};
  for (auto knot = inner; knot != outer; ++knot) {
    result.knots.push_back((*knot - begin) / (end - begin));
  }
  result.knots.insert(result.knots.end(), degree + 1, 1.0);
  const auto count = result.knots.size() - degree - 1;
  result.points.assign(whole.points.begin() + first, whole.points.begin() + first + count);
  return result;
}

}  // namespace

Vector3d BSplineCurve::position(double t) const {
  const BasisValues values = basis_values(knots, degree, std::clamp(t, 0.0, 1.0));
  Vector3d point = Vector3d::Zero();
  for (int i = 0; i <= degree; ++i) point += values.rows(0, i) * points[values.first + i];
  return point;
}

double BSplineCurve::polygon_length() const {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

BSplineCurve BSplineCurve::reversed() const {
  BSplineCurve result{degree, {}, {points.rbegin(), points.rend()}};
  for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot) {
    result.knots.push_back(1.0 - *knot);
  }
  return result;
}

void BSplineCurve::insert_knot(double t) { insert(*this, t, std::ranges::count(knots, t)); }

BSplineCurve BSplineCurve::part(double begin, double end) const {
  // Bit for bit, not over again through knots that are there.
  if (begin == 0.0 && end == 1.0) return *this;
  BSplineCurve whole = *this;
  // A cut beside a knot by rounding would leave a span of no width.
  begin = snapped(knots, begin);
  end = snapped(knots, end);
  if (begin > 0.0) saturate(whole, begin);
  if (end < 1.0) saturate(whole, end);
  return between(whole, begin, end);
}

BSplineCurve clamped(BSplineCurve curve) {
  // Between these all degree + 1 functions are there: the curve is not defined beyond.
  const double begin = curve.knots[curve.degree], end = curve.knots[curve.points.size()];
  saturate(curve, begin);
  saturate(curve, end);
  return between(curve, begin, end);
}

double gap_between(const BSplineCurve& one, const BSplineCurve& two) {
  std::vector<double> knots = one.knots;
  knots.insert(knots.end(), two.knots.begin(), two.knots.end());
  std::ranges::sort(knots);
  const int samples = std::max(one.degree, two.degree) + 1;
  double largest = (one.points.front() - two.points.front()).norm();
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (!(knots[k] > knots[k - 1])) continue;
    // Between knots of both the difference is one polynomial, which is zero if it is at so many
    // places.
    for (int i = 1; i <= samples; ++i) {
      const double t = knots[k - 1] + (knots[k] - knots[k - 1]) * i / samples;
      largest = std::max(largest, (one.position(t) - two.position(t)).norm());
    }
  }
  return largest;
}

}  // namespace hull::conversion

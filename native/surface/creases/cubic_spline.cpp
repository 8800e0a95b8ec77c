// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/cubic_spline.h"

#include <algorithm>
#include <cassert>

namespace hull::surface {
namespace {

Vector3d between(const Vector3d& a, const Vector3d& b, double low, double high, double t) {
  const double s = (t - low) / (high - low);
  return (1.0 - s) * a + s * b;
}

}  // namespace

CubicSpline::CubicSpline(std::vector<Vector3d> points, std::vector<double> knots)
    : points_(std::move(points)), knots_(std::move(knots)) {
  assert(points_.size() >= 4 && knots_.size() == points_.size() + 4);
}

CurveJet CubicSpline::evaluate(double t, int order) const {
  assert(t >= begin() && t <= end());
  // Searched between the ends, so that t = end() falls into the last span.
  const auto first = knots_.begin() + 4, last = knots_.end() - 4;
  const auto span = std::upper_bound(first, last, t) - knots_.begin() - 1;
  // Of the span [k[2], k[3]]: point i belongs to the knots k[i], k[i + 1], k[i + 2] (de Boor 1978,
  // in the form of blossoms).
  const double* k = &knots_[span - 2];
  const Vector3d* p = &points_[span - 3];
  CurveJet jet;
  Vector3d c[] = {p[0], p[1], p[2], p[3]};
  for (int round = 1; round <= 3; ++round) {
    for (int i = 3; i >= round; --i) c[i] = between(c[i - 1], c[i], k[i - 1], k[i + 3 - round], t);
  }
  jet.point = c[3];
  if (order < 1) return jet;
  // Control points of the derivative: degree times differences over the knots that two points
  // share.
  Vector3d d[3];
  for (int i = 0; i < 3; ++i) d[i] = 3.0 / (k[i + 3] - k[i]) * (p[i + 1] - p[i]);
  jet.d1 = between(between(d[0], d[1], k[1], k[3], t), between(d[1], d[2], k[2], k[4], t), k[2],
                   k[3], t);
  if (order < 2) return jet;
  jet.d2 = between(2.0 / (k[3] - k[1]) * (d[1] - d[0]), 2.0 / (k[4] - k[2]) * (d[2] - d[1]), k[2],
                   k[3], t);
  return jet;
}

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/ship_spline.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hull::drawing {

namespace {

// Between two knots a cubic is looked at in so many steps: one that crosses and returns within a
// step is a curve's touch, not a crossing.
constexpr int kStepsPerSpan = 16;
constexpr int kHalvings = 60;

// The blossom (polar form) of the cubic that the spline has at `t`, at three arguments: de Boor's
// algorithm with another argument in each round.
Vector3d blossom(const surface::CubicSpline& spline, double t, const double* arguments) {
  const auto& knots = spline.knots();
  // The span that holds t; at the very end the last one, as the search leaves out the last four
  // knots.
  const auto span = std::upper_bound(knots.begin() + 4, knots.end() - 4, t) - knots.begin() - 1;
  const double* k = &knots[span - 2];
  const Vector3d* p = &spline.points()[span - 3];
  Vector3d c[] = {p[0], p[1], p[2], p[3]};
  for (int round = 1; round <= 3; ++round) {
    for (int i = 3; i >= round; --i) {
      const double low = k[i - 1], high = k[i + 3 - round];
      const double share = (arguments[round - 1] - low) / (high - low);
      c[i] = ((1.0 - share) * c[i - 1] + share * c[i]).eval();
    }
  }
  return c[3];
}

double bisected(const surface::CubicSpline& spline, int axis, double limit, double low, double high,
                bool above_at_low) {
  // To the last bit of a double, as parts end exactly at the limit.
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const bool above = spline.evaluate(middle, 0).point[axis] >= limit;
    (above == above_at_low ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

surface::CubicSpline part_of_spline(const surface::CubicSpline& spline, double from, double to) {
  assert(spline.begin() <= from && from < to && to <= spline.end());
  // Fourfold, so that the part ends in its first and last control points.
  std::vector<double> knots(4, from);
  for (const double knot : spline.knots()) {
    if (from < knot && knot < to) knots.push_back(knot);
  }
  knots.insert(knots.end(), 4, to);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i + 4 < knots.size(); ++i) {
    // The point is a blossom of any of the cubics over its knots; a middle one is the most exact.
    std::size_t span = i;
    for (const std::size_t wanted : {i + 1, i + 2, i + 3, i}) {
      span = wanted;
      if (knots[span] < knots[span + 1]) break;
    }
    // A control point is the blossom at the three knots after its first one (polar forms).
    points.push_back(blossom(spline, 0.5 * (knots[span] + knots[span + 1]), &knots[i + 1]));
  }
  return surface::CubicSpline(std::move(points), std::move(knots));
}

std::vector<double> crossings_of_spline(const surface::CubicSpline& spline, int axis,
                                        double limit) {
  const auto& knots = spline.knots();
  std::vector<double> found;
  bool above = spline.evaluate(spline.begin(), 0).point[axis] >= limit;
  double previous = spline.begin();
  for (std::size_t span = 3; span + 4 < knots.size(); ++span) {
    if (!(knots[span] < knots[span + 1])) continue;
    for (int step = 1; step <= kStepsPerSpan; ++step) {
      const double share = static_cast<double>(step) / kStepsPerSpan;
      // The knot itself, so that spans join without a gap by rounding.
      const double t = step == kStepsPerSpan
                           ? knots[span + 1]
                           : knots[span] + share * (knots[span + 1] - knots[span]);
      const bool now = spline.evaluate(t, 0).point[axis] >= limit;
      // One that only touches the limit keeps its side and is no crossing.
      if (now != above) found.push_back(bisected(spline, axis, limit, previous, t, above));
      above = now;
      previous = t;
    }
  }
  return found;
}

}  // namespace hull::drawing

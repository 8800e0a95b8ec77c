// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/seam_samples.h"

#include <cmath>

namespace hull::conversion {
namespace {

// Between two knots of a seam.
constexpr int kFitted = 7, kMeasured = 17;
constexpr int kNearPoint = 4;  // so many times is the first place halved towards the point

std::vector<double> places(int inner, int samples) {
  std::vector<double> result;
  for (int k = 0; k <= inner; ++k) {
    const double begin = k > 0 ? std::exp2(k - 1 - inner) : 0.0, end = std::exp2(k - inner);
    for (int i = 0; i < samples; ++i) result.push_back(begin + (end - begin) * i / samples);
  }
  return result;
}

}  // namespace

// Of a clamped cubic: the degree over the width of the first span, 2^-inner.
double first_slope(int inner) { return 3.0 * std::exp2(inner); }

SeamSamples SeamSamples::for_fit(const CornerNet& before, const CornerNet& after) {
  return {before, after, places(before.inner, kFitted)};
}

SeamSamples SeamSamples::for_measuring(const CornerNet& before, const CornerNet& after) {
  std::vector<double> at = places(before.inner, kMeasured);
  for (int k = 1; k <= kNearPoint; ++k) at.push_back(at[1] * std::exp2(-k));
  return {before, after, at};
}

SeamSamples::SeamSamples(const CornerNet& before, const CornerNet& after,
                         const std::vector<double>& places) {
  for (double t : places) {
    points_.push_back({corner_functions(before.inner, before.beyond_v, t),
                       corner_functions(after.inner, after.beyond_u, t)});
  }
}

SeamVectors SeamSamples::vectors(int k, const CornerNet& before, const CornerNet& after) const {
  const SeamPoint& point = points_[k];
  const double first = first_slope(before.inner);
  SeamVectors result{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  for (int b = 0; b < before.count(); ++b) {
    // The seam is u = 0 of the square before and v = 0 of the one after: both derivatives across it
    // lead away from it, and at an end only the first two functions have a slope.
    result.along += point.before.slope[b] * before.at(0, b);
    result.before += first * point.before.value[b] * (before.at(1, b) - before.at(0, b));
    result.after += first * point.after.value[b] * (after.at(b, 1) - after.at(b, 0));
  }
  return result;
}

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/curve_errors.h"

#include <algorithm>

namespace hull::network {
namespace {

constexpr int kMeasuredOfSpan = 5;  // none of which is a place of fitted_spline()
constexpr int kSteps = 6;           // of Newton's, from the same parameter

double distance_from(const BSplineCurve& spline, double t, const Vector3d& point) {
  // The least on the way: all of these are places of the spline, whether steps converge or not.
  double least = (spline.position(t) - point).norm();
  for (int step = 0; step < kSteps; ++step) {
    const Points3 jet = spline_jet(spline, t);
    const Vector3d slope = jet.row(1), off = point - Vector3d(jet.row(0));
    const double square = slope.squaredNorm();
    if (!(square > 0.0)) break;
    t = std::clamp(t + off.dot(slope) / square, 0.0, 1.0);
    least = std::min(least, (spline.position(t) - point).norm());
  }
  return least;
}

}  // namespace

std::vector<double> edge_errors(const NetworkFrame& frame, const EdgeSplines& splines) {
  std::vector<double> errors;
  for (std::size_t e = 0; e < splines.fitted.size(); ++e) {
    const BSplineCurve& spline = splines.fitted[e].curve;
    // A cubic has three points more than spans.
    const int count = kMeasuredOfSpan * (static_cast<int>(spline.points.size()) - 3);
    double worst = 0.0;
    for (int i = 0; i < count; ++i) {
      const double t = (i + 0.5) / count;
      worst = std::max(worst, distance_from(spline, t, frame.shapes[e].given(t)));
    }
    errors.push_back(worst);
  }
  return errors;
}

}  // namespace hull::network

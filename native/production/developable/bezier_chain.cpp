// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/bezier_chain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hull::production {

BernsteinVector polynomial_of(const BezierSpan& span) {
  BernsteinVector result;
  for (const Vector3d& p : span) {
    for (int k = 0; k < 3; ++k) result[k].push_back(p[k]);
  }
  return result;
}

BernsteinVector derivative_of(const BezierSpan& span) {
  BernsteinVector result;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result[k].push_back(3.0 * (span[i + 1][k] - span[i][k]));
  }
  return result;
}

BezierChain::BezierChain(std::vector<BezierSpan> spans) : spans_(std::move(spans)) {
  if (spans_.empty()) throw std::invalid_argument("A curve needs at least one span.");
  for (const BezierSpan& span : spans_) {
    for (const Vector3d& p : span) {
      if (!p.allFinite()) throw std::invalid_argument("A curve's points must be finite numbers.");
    }
  }
}

surface::CurveJet BezierChain::at(double s) const {
  // The last span has its end, too, at which none begins.
  const int k = std::clamp(static_cast<int>(std::floor(s)), 0, span_count() - 1);
  const BezierSpan& b = spans_[k];
  const double t = s - k, u = 1.0 - t;
  const Vector3d d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  return {u * u * (u * b[0] + 3.0 * t * b[1]) + t * t * (3.0 * u * b[2] + t * b[3]),
          3.0 * (u * u * d0 + 2.0 * u * t * d1 + t * t * d2),
          6.0 * (u * (d1 - d0) + t * (d2 - d1))};
}

}  // namespace hull::production

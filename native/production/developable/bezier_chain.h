// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/vectors.h"
#include "production/developable/bernstein.h"
#include "surface/creases/cubic_spline.h"

namespace hull::production {

using BezierSpan = std::array<Vector3d, 4>;  // Bézier points

BernsteinVector polynomial_of(const BezierSpan& span);
BernsteinVector derivative_of(const BezierSpan& span);

// A curve of cubic spans, span k over the parameters [k, k + 1].
class BezierChain {
 public:
  // Throws std::invalid_argument if there is no span, and for points that are not finite.
  explicit BezierChain(std::vector<BezierSpan> spans);

  int span_count() const { return static_cast<int>(spans_.size()); }
  const BezierSpan& span(int k) const { return spans_[k]; }
  // s within [0, span_count()], at a joint of the span that begins there; derivatives by s.
  surface::CurveJet at(double s) const;

 private:
  std::vector<BezierSpan> spans_;
};

}  // namespace hull::production

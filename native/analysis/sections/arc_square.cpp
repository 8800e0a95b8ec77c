// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/arc_square.h"

#include <cmath>

#include "surface/wide_code.h"

namespace hull {

double monotonic_root(const double* c) {
  if ((c[0] >= 0.0) == (c[3] >= 0.0)) return std::abs(c[0]) < std::abs(c[3]) ? 0.0 : 1.0;
  const double p1 = 3.0 * (c[1] - c[0]), p2 = 3.0 * (c[0] - 2.0 * c[1] + c[2]);
  const double p3 = c[3] - c[0] + 3.0 * (c[1] - c[2]);
  double low = 0.0, high = 1.0, t = c[0] / (c[0] - c[3]);
  for (int i = 0; i < 60; ++i) {
    const double value = c[0] + t * (p1 + t * (p2 + t * p3));
    if (value == 0.0) return t;
    ((value >= 0.0) == (c[0] >= 0.0) ? low : high) = t;
    const double slope = p1 + t * (2.0 * p2 + t * 3.0 * p3);
    double next = t - value / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - t);
    t = next;
    if (change < 1e-15) break;
  }
  return t;
}

HULL_WIDE ArcPoint arc_point(const ArcSquare& square, double u) {
  const BernsteinBasis at_u(u);
  const Column h_column(square.h, at_u);
  const double v = monotonic_root(h_column.c);
  const BernsteinBasis at_v(v);
  const NetJet h(h_column, at_v), a(Column(square.a, at_u), at_v), b(Column(square.b, at_u), at_v);
  const double slope = h.dv != 0.0 ? -h.du / h.dv : 0.0;
  return {a.value, b.value, a.du + a.dv * slope, b.du + b.dv * slope, v};
}

bool is_monotonic(const ArcSquare& square) {
  const SlopeRange hu = slope_range_u(square.h), hv = slope_range_v(square.h);
  const SlopeRange bu = slope_range_u(square.b), bv = slope_range_v(square.b);
  const auto product = [](const SlopeRange& x, const SlopeRange& y) {
    const double p[] = {x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high};
    return SlopeRange{*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
  };
  const SlopeRange first = product(hu, bv), second = product(hv, bu);
  return first.low - second.high > 0.0 || first.high - second.low < 0.0;
}

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/arc_square.h"

#include "surface/wide_code.h"

namespace hull::analysis {

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
  // Thirds of the slopes: signs are all that counts.
  const SlopeRange hu = slope_range_u(square.h), hv = slope_range_v(square.h);
  const SlopeRange bu = slope_range_u(square.b), bv = slope_range_v(square.b);
  const auto product = [](const SlopeRange& x, const SlopeRange& y) {
    const double p[] = {x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high};
    return SlopeRange{*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
  };
  const SlopeRange first = product(hu, bv), second = product(hv, bu);
  return first.low - second.high > 0.0 || first.high - second.low < 0.0;
}

}  // namespace hull::analysis

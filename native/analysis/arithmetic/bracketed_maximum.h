// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace hull::analysis {

struct Maximum {
  double place, value;
};

// A local maximum of f within [a, b], to `width` of its place, by parabolas through three places
// and, where these don't help, golden sections (Brent 1973, chapter 5). Of a function with one
// maximum it is that; it may be an end, but for `width`. REQUIRES: a < b, width > 0.
template <class Function>
Maximum bracketed_maximum(const Function& f, double a, double b, double width) {
  constexpr double kGolden = 0.3819660112501051;
  constexpr int kMostSteps = 100;
  // The best place so far, the second best and the one before that.
  double x = a + kGolden * (b - a), w = x, v = x;
  double fx = f(x), fw = fx, fv = fx;
  double step = 0.0, before_last = 0.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double middle = 0.5 * (a + b);
    if (std::abs(x - middle) <= width - 0.5 * (b - a)) break;
    // The top of the parabola is at x + p / q.
    const double r = (x - w) * (fx - fv), t = (x - v) * (fx - fw);
    double p = (x - v) * t - (x - w) * r, q = 2.0 * (t - r);
    if (q > 0.0) p = -p;
    q = std::abs(q);
    const bool helps =
        std::abs(p) < std::abs(0.5 * q * before_last) && p > q * (a - x) && p < q * (b - x);
    before_last = helps ? step : (x < middle ? b - x : a - x);
    step = helps ? p / q : kGolden * before_last;
    if (helps && (x + step - a < width || b - x - step < width)) {
      step = x < middle ? 0.5 * width : -0.5 * width;
    }
    const double u = x + (std::abs(step) >= 0.5 * width ? step : std::copysign(0.5 * width, step));
    const double fu = f(u);
    if (fu >= fx) {
      (u < x ? b : a) = x;
      v = w;
      fv = fw;
      w = x;
      fw = fx;
      x = u;
      fx = fu;
      continue;
    }
    (u < x ? a : b) = u;
    if (fu >= fw || w == x) {
      v = w;
      fv = fw;
      w = u;
      fw = fu;
    } else if (fu >= fv || v == x || v == w) {
      v = u;
      fv = fu;
    }
  }
  return {x, fx};
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace hull::analysis {

struct Maximum {
  double place, value;
};

inline constexpr double kGoldenSection = 0.3819660112501051;

// What Brent's search knows of a function: the best place so far, the second best and the one
// before that.
struct BestPlaces {
  double x, fx, w, fw, v, fv;
};

// Brent's search within [a, b] from `known` places on, one of which may be an end. `reach`: the
// longest step that a first parabola may lead to is half of it.
template <class Function>
Maximum maximum_from(const Function& f, double a, double b, double width, BestPlaces known,
                     double reach) {
  constexpr int kMostSteps = 100;
  auto [x, fx, w, fw, v, fv] = known;
  double step = reach, before_last = reach;
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
    step = helps ? p / q : kGoldenSection * before_last;
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

// A local maximum of f within [a, b], to `width` of its place, by parabolas through three places
// and, where these don't help, golden sections (Brent 1973, chapter 5). Of a function with one
// maximum it is that; it may be an end, but for `width`. REQUIRES: a < b, width > 0.
template <class Function>
Maximum bracketed_maximum(const Function& f, double a, double b, double width) {
  const double x = a + kGoldenSection * (b - a), fx = f(x);
  return maximum_from(f, a, b, width, {x, fx, x, fx, x, fx}, 0.0);
}

// The same from the values at both ends and at a place between them that is as high as either.
template <class Function>
Maximum bracketed_maximum(const Function& f, const Maximum& a, const Maximum& x, const Maximum& b,
                          double width) {
  const Maximum &w = a.value > b.value ? a : b, &v = a.value > b.value ? b : a;
  return maximum_from(f, a.place, b.place, width,
                      {x.place, x.value, w.place, w.value, v.place, v.value}, b.place - a.place);
}

}  // namespace hull::analysis

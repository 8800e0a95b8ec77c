// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace hull::analysis {

// A root of a continuous function between a and b, where its values fa and fb differ in sign (or
// one is zero), to `tolerance` in the argument or rounding. Anderson and Björck's rule (1973) of
// false position, bisecting where that is slow. Calls f at most about 100 times.
template <typename Function>
double bracketed_root(const Function& f, double a, double fa, double b, double fb,
                      double tolerance) {
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  double width = std::abs(b - a);
  for (int i = 0; i < 100; ++i) {
    // The bracket has to halve at least every third step.
    if (i % 3 == 2) {
      if (std::abs(b - a) > 0.5 * width) fa = -fb;
      width = std::abs(b - a);
    }
    // Rounding must not lead out of the bracket: f may not be defined there.
    const double c = std::clamp(b - fb * (b - a) / (fb - fa), std::min(a, b), std::max(a, b));
    const double fc = f(c);
    if (fc == 0.0) return c;
    const double moved = std::abs(c - b);
    if ((fc > 0.0) != (fb > 0.0)) {
      a = b;
      fa = fb;
    } else {
      const double keep = 1.0 - fc / fb;
      fa *= keep > 0.0 ? keep : 0.5;
    }
    b = c;
    fb = fc;
    if (std::abs(b - a) <= tolerance || moved <= 0.1 * tolerance) break;
  }
  return b;
}

}  // namespace hull::analysis

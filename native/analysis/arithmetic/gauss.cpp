// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/gauss.h"

#include <cmath>
#include <numbers>

namespace hull::analysis {

GaussRule gauss_rule(int n) {
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    // Newton's iteration on the Legendre polynomial P_n from Chebyshev's guess.
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int step = 0; step < 100; ++step) {
      double p = 1.0, previous = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double before = previous;
        previous = p;
        p = ((2.0 * k - 1.0) * x * previous - (k - 1.0) * before) / k;
      }
      // The derivative by P_n and P_(n-1).
      slope = n * (x * p - previous) / (x * x - 1.0);
      const double change = p / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    // From [-1, 1], where Chebyshev's guesses fall, to [0, 1], where weights 2 / ((1 - x^2) P_n'^2)
    // are halved.
    rule.nodes[n - 1 - i] = 0.5 * (1.0 + x);
    rule.weights[n - 1 - i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/estimating_rule.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hull::analysis {

EstimatingRule::EstimatingRule(int n) : rule_(gauss_rule(n)) {
  for (int i = 0; i < n; ++i) {
    const double x = 2.0 * rule_.nodes[i] - 1.0;
    // A coefficient of the series is (2 d + 1) times the integral with the polynomial of degree d,
    // here n - 2 and n - 1.
    high_[i] = rule_.weights[i] * (2 * n - 3) * std::legendre(n - 2, x);
    highest_[i] = rule_.weights[i] * (2 * n - 1) * std::legendre(n - 1, x);
  }
}

const EstimatingRule& EstimatingRule::of(int n) {
  assert(n >= 2 && n <= kMostNodes);
  // Made once: nodes are had by iteration.
  static const std::vector<EstimatingRule> rules = [] {
    std::vector<EstimatingRule> all;
    for (int k = 2; k <= kMostNodes; ++k) all.push_back(EstimatingRule(k));
    return all;
  }();
  return rules[n - 2];
}

double EstimatingRule::error(const Values& values) const {
  double a = 0.0, b = 0.0, mean = 0.0;
  for (int i = 0; i < count(); ++i) {
    a += high_[i] * values[i];
    b += highest_[i] * values[i];
    mean += rule_.weights[i] * std::abs(values[i]);
  }
  // The two highest Legendre coefficients that the nodes can tell. Where they are small beside the
  // mean the series falls fast, and the error is smaller by as much again.
  const double top = std::abs(a) + std::abs(b);
  return mean > 0.0 ? top * std::min(1.0, top / mean) : 0.0;
}

}  // namespace hull::analysis

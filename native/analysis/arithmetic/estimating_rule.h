// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/arithmetic/gauss.h"

namespace hull::analysis {

// A Gauss rule on [0, 1] that tells from the integrand's values at its nodes how much it may be
// off: the coefficients of an analytic function's Legendre series fall geometrically, and the error
// of a rule of n nodes is of the order of that of degree 2 n, about the square of those of degree n
// - 2 and n - 1, which the values give.
class EstimatingRule {
 public:
  static constexpr int kMostNodes = 10;
  using Values = std::array<double, kMostNodes>;  // at the nodes; the first count() of them

  // The rule of 2 <= n <= kMostNodes nodes.
  static const EstimatingRule& of(int n);

  int count() const { return static_cast<int>(rule_.nodes.size()); }
  double node(int i) const { return rule_.nodes[i]; }
  double weight(int i) const { return rule_.weights[i]; }
  double error(const Values& values) const;

 private:
  explicit EstimatingRule(int n);

  GaussRule rule_;
  Values high_{}, highest_{};  // weights times those two polynomials, at the nodes
};

}  // namespace hull::analysis

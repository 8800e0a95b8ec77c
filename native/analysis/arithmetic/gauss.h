// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hull::analysis {

// Gauss–Legendre quadrature on [0, 1]: exact for polynomials of degree 2 n - 1.
struct GaussRule {
  std::vector<double> nodes, weights;
};

// The rule of n >= 1 nodes, to rounding.
GaussRule gauss_rule(int n);

}  // namespace hull::analysis

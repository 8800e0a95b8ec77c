// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/spline_basis.h"

#include <algorithm>

namespace hull::analysis {

using Eigen::Index;

Index span_of(const std::vector<double>& knots, int degree, double t) {
  const auto begin = knots.begin() + degree, end = knots.end() - degree - 1;
  return std::upper_bound(begin + 1, end, t) - 1 - knots.begin();
}

// From the one spline of degree 0 on, a degree a round, by the recursion of Cox and de Boor; the
// last rounds differentiate.
Eigen::VectorXd basis_at(const std::vector<double>& knots, int degree, double t, Index span,
                         int order) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(degree + 1);
  // values[degree - p + k] is of spline span - p + k, of degree p.
  values[degree] = 1.0;
  for (int p = 1; p <= degree; ++p) {
    const bool is_derivative = p > degree - order;
    for (int k = 0; k <= p; ++k) {
      const Index i = span - p + k;
      const double left = knots[i + p] - knots[i], right = knots[i + p + 1] - knots[i + 1];
      // Of the two splines of the degree below; those beyond the span have none there.
      const double before = k > 0 && left > 0.0 ? values[degree - p + k] / left : 0.0;
      const double after = k < p && right > 0.0 ? values[degree - p + k + 1] / right : 0.0;
      values[degree - p + k] = is_derivative
                                   ? p * (before - after)
                                   : (t - knots[i]) * before + (knots[i + p + 1] - t) * after;
    }
  }
  return values;
}

}  // namespace hull::analysis

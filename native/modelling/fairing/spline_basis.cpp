// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/spline_basis.h"

#include <algorithm>

namespace hull::modelling {
namespace {

using Eigen::Index;

// Of the spline number i of a degree, at a parameter in a span: by the recursions of Cox and de
// Boor.
double basis_derivative(const std::vector<double>& knots, Index i, int degree, double t, Index span,
                        int order) {
  if (degree == 0) return order == 0 && i == span ? 1.0 : 0.0;
  const double left = knots[i + degree] - knots[i], right = knots[i + degree + 1] - knots[i + 1];
  double value = 0.0;
  if (order > 0) {
    if (left > 0.0) value += basis_derivative(knots, i, degree - 1, t, span, order - 1) / left;
    if (right > 0.0) {
      value -= basis_derivative(knots, i + 1, degree - 1, t, span, order - 1) / right;
    }
    return degree * value;
  }
  if (left > 0.0) {
    value += (t - knots[i]) / left * basis_derivative(knots, i, degree - 1, t, span, 0);
  }
  if (right > 0.0) {
    value += (knots[i + degree + 1] - t) / right *
             basis_derivative(knots, i + 1, degree - 1, t, span, 0);
  }
  return value;
}

}  // namespace

Index span_of(const std::vector<double>& knots, double t) {
  const auto begin = knots.begin() + kDegree, end = knots.end() - kOrder;
  return std::upper_bound(begin + 1, end, t) - 1 - knots.begin();
}

Eigen::VectorXd basis_at(const std::vector<double>& knots, double t, Index span, int order) {
  Eigen::VectorXd values(kOrder);
  for (Index k = 0; k < kOrder; ++k) {
    values[k] = basis_derivative(knots, span - kDegree + k, kDegree, t, span, order);
  }
  return values;
}

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/spline_basis.h"
#include "modelling/fairing/curve_smoothing.h"

namespace hull::modelling {

Eigen::MatrixXd SmoothCurve::evaluate(const std::vector<double>& parameters, int order) const {
  if (order < 0 || order > degree) {
    throw std::invalid_argument("A derivative's order is from 0 to " + std::to_string(degree) +
                                ".");
  }
  Eigen::MatrixXd values(static_cast<Eigen::Index>(parameters.size()), coefficients.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const double t = parameters[static_cast<std::size_t>(i)];
    if (!std::isfinite(t)) throw std::invalid_argument("A parameter is no number.");
    const Eigen::Index span = analysis::span_of(knots, degree, t);
    values.row(i) = analysis::basis_at(knots, degree, t, span, order).transpose() *
                    coefficients.middleRows(span - degree, degree + 1);
  }
  return values;
}

}  // namespace hull::modelling

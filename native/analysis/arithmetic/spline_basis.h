// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::analysis {

// B-splines of a degree over knots, the first and last of which are there degree + 1 times.

// The span of a parameter: knots[span] <= t < knots[span + 1]; an end span for what is beyond.
Eigen::Index span_of(const std::vector<double>& knots, int degree, double t);

// The degree + 1 splines of a span at a parameter, from number span - degree on, or their
// derivatives of an order from 0 to the degree (de Boor 1978).
Eigen::VectorXd basis_at(const std::vector<double>& knots, int degree, double t, Eigen::Index span,
                         int order);

}  // namespace hull::analysis

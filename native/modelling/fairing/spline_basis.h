// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::modelling {

inline constexpr int kDegree = 3, kOrder = 4;

// Cubic B-splines over knots, the first and last of which are there four times.

// The span of a parameter: knots[span] <= t < knots[span + 1]; an end span for what is beyond.
Eigen::Index span_of(const std::vector<double>& knots, double t);

// The four splines of a span at a parameter, from number span - 3 on, or their derivatives of an
// order up to 3 (de Boor 1978).
Eigen::VectorXd basis_at(const std::vector<double>& knots, double t, Eigen::Index span, int order);

}  // namespace hull::modelling

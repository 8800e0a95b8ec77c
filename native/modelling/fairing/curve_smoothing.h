// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::modelling {

// A cubic spline of any dimension: coefficients (a row each) over knots, the first and last of
// which are there four times.
struct SmoothCurve {
  std::vector<double> knots;
  Eigen::MatrixXd coefficients;
  double error;  // E = Σ w |f(t) - q|²
  double p;      // what weighs errors against jumps; infinite where none had to be weighed
  // No knots more could bring the error down, so that it is above what was asked for. Never where
  // no derivatives are given.
  bool is_short_of_knots;

  // A row for each parameter: the derivative of an order from 0 to 3. Beyond its ends the curve
  // goes on as its end spans do.
  Eigen::MatrixXd evaluate(const std::vector<double>& parameters, int order = 0) const;
};

struct SmoothingOptions {
  // Rising strictly, one for each point; none: chord lengths, m.
  std::vector<double> parameters;
  std::vector<double> weights;  // positive, one for each point; none: 1
  // Where the curve begins and ends, and its derivatives by the parameter there: up to two rows,
  // the place and the first derivative. None: free.
  Eigen::MatrixXd start, end;
};

// The smooth spline f through points q (a row each) of which the mean deviation is M (Dierckx 1993,
// chapter 5; Koelman 1999, 5.3): the least Σ (jump of f‴ at a knot)² with
//
//   E = Σ w |f(t) - q|² <= S = M² Σ w.
//
// Knots come one at a time into the middle of the span with the largest error (or to its middle
// point, where each coefficient has to keep a point of its own) until the least squares spline has
// E <= S. Then E = S is met, to 1e-9 of S, by the p of the least Σ jump² + p E. A straight or cubic
// curve within S has no inner knots, and E < S. M = 0 interpolates, with no knot at the second and
// the last but one point.
//
// Throws std::invalid_argument for fewer than four points, and for what is none of these.
SmoothCurve smooth_curve(const Eigen::MatrixXd& points, double deviation,
                         const SmoothingOptions& options = {});

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::modelling {

// A spline of any dimension: coefficients (a row each) over knots, the first and last of which are
// there degree + 1 times.
struct SmoothCurve {
  int degree;
  std::vector<double> knots;
  Eigen::MatrixXd coefficients;
  double error;  // E = Σ w |f(t) - q|²
  double p;      // what weighs errors against jumps; infinite where none had to be weighed
  // No knots more could bring the error down, so that it is above what was asked for. Never where
  // no derivatives are given.
  bool is_short_of_knots;

  // A row for each parameter: the derivative of an order from 0 to the degree. Beyond its ends the
  // curve goes on as its end spans do.
  Eigen::MatrixXd evaluate(const std::vector<double>& parameters, int order = 0) const;
};

// How a curve begins or ends.
struct CurveEnd {
  // The place and derivatives by the parameter: up to three rows, each needing those before it. The
  // second derivative needs a degree of 5, or just as many points and conditions as a polynomial of
  // the degree meets. None: free.
  Eigen::MatrixXd given;
  // The second derivative is zero; with a degree of 3 at least, and two rows given at most.
  bool is_straight = false;
};

struct SmoothingOptions {
  // Rising strictly, one for each point; none: chord lengths, m.
  std::vector<double> parameters;
  std::vector<double> weights;  // positive, one for each point; none: 1
  CurveEnd start, end;
  int degree = 3;  // from 1 to 5
  // Where knots are needed, there is one at each point that interpolation has one at: the fairest
  // curve of all with knots at points, but with the most coefficients.
  bool knots_at_points = false;
};

// The smooth spline f of degree k through points q (a row each) of which the mean deviation is M
// (Dierckx 1993, chapter 5; Koelman 1999, 5.3): the least Σ |jump of the kth derivative at a knot|²
// with
//
//   E = Σ w |f(t) - q|² <= S = M² Σ w.
//
// Knots come one at a time into the middle of the span with the largest error (or to its middle
// point, where each coefficient has to keep a point of its own) until the least squares spline has
// E <= S. Then E = S is met, to 1e-9 of S, by the p of the least Σ jump² + p E. A polynomial of the
// degree within S has no inner knots, and E < S. M = 0 interpolates; a cubic has no knot at the
// second and the last but one point then, unless its ends have conditions. An even degree has one
// knot less at the end than at the start.
//
// Throws std::invalid_argument for fewer points and conditions than a polynomial of the degree has
// coefficients, for places and tangents at both ends that no spline of the degree has with so few
// knots, and for what is none of these.
SmoothCurve smooth_curve(const Eigen::MatrixXd& points, double deviation,
                         const SmoothingOptions& options = {});

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>

#include "surface/pieces/bicubic.h"

namespace hull::conversion {

// A residual's derivative by three unknowns: those of a point.
struct PointSlope {
  int point;  // unknowns 3 point to 3 point + 2
  Vector3d slope;
};

// The normal equations of residuals that depend on few of many points each, summed up residual by
// residual: a product of whole Jacobians would mostly multiply zeros.
class NormalEquations {
 public:
  explicit NormalEquations(int points)
      : matrix_(Eigen::MatrixXd::Zero(3 * points, 3 * points)),
        right_(Eigen::VectorXd::Zero(3 * points)) {}

  // A point may be there several times.
  void add(double residual, std::span<const PointSlope> slopes) {
    squares_ += residual * residual;
    for (const PointSlope& one : slopes) {
      right_.segment<3>(3 * one.point) -= residual * one.slope;
      for (const PointSlope& two : slopes) {
        if (two.point > one.point) continue;
        matrix_.block<3, 3>(3 * one.point, 3 * two.point) += one.slope * two.slope.transpose();
      }
    }
  }

  double squares() const { return squares_; }
  Eigen::Index size() const { return right_.size(); }

  // The step with u times the diagonal added to it (Marquardt's damping).
  Eigen::VectorXd step(double u) const {
    // Of unknowns that hardly count.
    constexpr double kLeastDiagonal = 1e-6;
    Eigen::MatrixXd damped = matrix_;
    for (Eigen::Index i = 0; i < size(); ++i) {
      damped(i, i) += u * std::max(matrix_(i, i), kLeastDiagonal);
    }
    return damped.llt().solve(right_);
  }

  // By how much a step makes the sum of squares less if the residuals are linear.
  double gain(const Eigen::VectorXd& step) const {
    return 2.0 * right_.dot(step) - step.dot(matrix_.selfadjointView<Eigen::Lower>() * step);
  }

 private:
  Eigen::MatrixXd matrix_;  // its lower half
  Eigen::VectorXd right_;
  double squares_ = 0.0;
};

struct LeastSquaresLimits {
  int steps;
  double least_gain;  // in the sum of squares; a step that changes it by less is the last
};

// Minimises a sum of squares, beginning at `x`: Levenberg-Marquardt with the damping of Nielsen
// (Madsen, Nielsen & Tingleff 2004, algorithm 3.16). A Problem has
//   NormalEquations linearised(const Eigen::VectorXd& x) const;
//   double squares(const Eigen::VectorXd& x) const;
template <class Problem>
void minimise(const Problem& problem, const LeastSquaresLimits& limits, Eigen::VectorXd& x) {
  constexpr double kFirstDamping = 1e-4, kLeastStep = 1e-8;
  double damping = kFirstDamping, growth = 2.0;
  NormalEquations equations = problem.linearised(x);
  for (int i = 1; i < limits.steps; ++i) {
    const Eigen::VectorXd step = equations.step(damping);
    if (!(step.norm() > kLeastStep * (x.norm() + kLeastStep))) return;
    const double change = equations.squares() - problem.squares(x + step);
    const double ratio = change / equations.gain(step);
    if (ratio > 0.0) x += step;
    if (std::abs(change) < limits.least_gain) return;
    if (ratio > 0.0) {
      equations = problem.linearised(x);
      damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3));
      growth = 2.0;
    } else {
      damping *= growth;
      growth *= 2.0;
    }
  }
}

}  // namespace hull::conversion

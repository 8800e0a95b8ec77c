// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/least_squares.h"

#include <ceres/tiny_solver.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace hull::conversion {
namespace {

// Points of a chain in space, whose links want lengths and whose points want places: residuals of
// one point and of two, not linear.
class Chain {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Chain(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> at(-1.0, 1.0), length(0.5, 1.5);
    for (int i = 0; i < count; ++i) {
      places_.emplace_back(at(random) + i, at(random), at(random));
      lengths_.push_back(length(random));
    }
  }

  int count() const { return static_cast<int>(places_.size()); }
  int NumResiduals() const { return 4 * count() - 1; }
  int NumParameters() const { return 3 * count(); }

  template <class Visit>
  void for_each(const Eigen::VectorXd& x, const Visit& visit) const {
    for (int i = 0; i < count(); ++i) {
      const Vector3d off = x.segment<3>(3 * i) - places_[i];
      for (int c = 0; c < 3; ++c) visit(0.3 * off[c], std::vector{PointSlope{i, 0.3 * unit(c)}});
    }
    for (int i = 0; i + 1 < count(); ++i) {
      const Vector3d link = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
      visit(link.norm() - lengths_[i],
            std::vector{PointSlope{i, -link.normalized()}, PointSlope{i + 1, link.normalized()}});
    }
  }

  double squares(const Eigen::VectorXd& x) const {
    double sum = 0.0;
    for_each(x, [&](double residual, const auto&) { sum += residual * residual; });
    return sum;
  }

  NormalEquations linearised(const Eigen::VectorXd& x) const {
    NormalEquations equations(count());
    for_each(x, [&](double residual, const auto& slopes) { equations.add(residual, slopes); });
    return equations;
  }

  // As Ceres wants it.
  bool operator()(const double* values, double* residuals, double* jacobian) const {
    Eigen::Map<Eigen::MatrixXd> slopes(jacobian, jacobian ? NumResiduals() : 0, NumParameters());
    slopes.setZero();
    int row = 0;
    for_each(Eigen::Map<const Eigen::VectorXd>(values, NumParameters()),
             [&](double residual, const auto& found) {
               residuals[row] = residual;
               for (const PointSlope& one : found) {
                 if (jacobian) slopes.block<1, 3>(row, 3 * one.point) = one.slope.transpose();
               }
               ++row;
             });
    return true;
  }

  Eigen::VectorXd start() const {
    Eigen::VectorXd x(NumParameters());
    for (int i = 0; i < count(); ++i) x.segment<3>(3 * i) = places_[i];
    return x;
  }

 private:
  static Vector3d unit(int c) { return Vector3d::Unit(c); }

  std::vector<Vector3d> places_;
  std::vector<double> lengths_;
};

// The same damping, from whole Jacobians: the same steps but for rounding.
TEST(LeastSquares, TakesTheStepsOfCeres) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const Chain chain(2 + trial, random);
    double before = chain.squares(chain.start());
    for (int steps : {2, 4, 8}) {
      Eigen::VectorXd own = chain.start(), theirs = own;
      minimise(chain, {steps, 0.0}, own);
      ceres::TinySolver<Chain> solver;
      solver.options.max_num_iterations = steps;
      solver.options.function_tolerance = solver.options.gradient_tolerance = 0.0;
      solver.Solve(chain, &theirs);
      EXPECT_LT((own - theirs).norm(), 1e-10 * own.norm());
      EXPECT_LE(chain.squares(own), before);
      before = chain.squares(own);
    }
    EXPECT_LT(before, 0.9 * chain.squares(chain.start()));
  }
}

// (J^T J + u diag(J^T J)) step = -J^T r, and the gain that a linear problem would have.
TEST(LeastSquares, StepSolvesTheDampedEquations) {
  std::mt19937 random(11);
  const Chain chain(9, random);
  const Eigen::VectorXd x = chain.start();
  Eigen::VectorXd r(chain.NumResiduals());
  Eigen::MatrixXd J(chain.NumResiduals(), chain.NumParameters());
  chain(x.data(), r.data(), J.data());
  Eigen::MatrixXd H = J.transpose() * J;
  const NormalEquations equations = chain.linearised(x);
  const Eigen::VectorXd step = equations.step(0.25);
  const double linear = r.squaredNorm() - (r + J * step).squaredNorm();
  EXPECT_NEAR(equations.gain(step), linear, 1e-13 * r.squaredNorm());
  H.diagonal() *= 1.25;
  EXPECT_LT((H * step + J.transpose() * r).norm(), 1e-13 * r.norm());
}

TEST(LeastSquares, APointMayBeNamedTwice) {
  NormalEquations once(2), twice(2);
  const Vector3d a(1.0, 2.0, -1.0), b(0.5, 0.0, 3.0);
  once.add(2.0, std::vector{PointSlope{1, a + b}});
  twice.add(2.0, std::vector{PointSlope{1, a}, PointSlope{1, b}});
  EXPECT_LT((once.step(0.5) - twice.step(0.5)).norm(), 1e-15);
  EXPECT_GT(once.step(0.5).norm(), 0.1);
}

}  // namespace
}  // namespace hull::conversion

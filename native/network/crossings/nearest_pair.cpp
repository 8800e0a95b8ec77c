// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/crossings/nearest_pair.h"

#include <Eigen/Dense>
#include <algorithm>

namespace hull::network {
namespace {

using Eigen::Matrix2d;

constexpr int kMostNewtonSteps = 100;
constexpr double kLeastSlope = 1e-3;  // of the Hessian's larger eigenvalue: below it is raised

struct Approach {
  double half_square;
  Vector2d slope;
  Matrix2d bend;
};

// Both parameters at once; one that leads beyond its curve's end is left out while it does.
class PairDescent {
 public:
  PairDescent(const NurbsCurve& first, const NurbsCurve& second) : first_(first), second_(second) {
    low_ = {first.begin(), second.begin()};
    high_ = {first.end(), second.end()};
  }

  Vector2d run(Vector2d at) const {
    at = at.cwiseMax(low_).cwiseMin(high_);
    Approach here = approach_at(at);
    for (int count = 0; count < kMostNewtonSteps; ++count) {
      const Vector2d step = newton_step(at, here);
      if (step.isZero(0.0)) break;
      bool is_lower = false;
      Vector2d next = at;
      Approach there = here;
      // A whole step may overshoot. If a small part of it is not lower, only rounding is left.
      for (double share = 1.0; share > 1e-4 && !is_lower; share *= 0.5) {
        next = (at + share * step).cwiseMax(low_).cwiseMin(high_);
        if (next == at) break;
        there = approach_at(next);
        is_lower = there.half_square < here.half_square;
      }
      if (!is_lower) break;
      at = next;
      here = there;
    }
    return at;
  }

 private:
  Approach approach_at(const Vector2d& at) const {
    const Points3 a = first_.evaluate(at[0], 2), b = second_.evaluate(at[1], 2);
    const Eigen::RowVector3d d = a.row(0) - b.row(0);
    Approach approach;
    approach.half_square = 0.5 * d.squaredNorm();
    // Of half the square of a(s) - b(t): the derivatives by s and t.
    approach.slope = {d.dot(a.row(1)), -d.dot(b.row(1))};
    const double mixed = -a.row(1).dot(b.row(1));
    approach.bend << a.row(1).squaredNorm() + d.dot(a.row(2)), mixed, mixed,
        b.row(1).squaredNorm() - d.dot(b.row(2));
    return approach;
  }

  // An end of a curve from which the slope leads outwards stays.
  Vector2d newton_step(const Vector2d& at, const Approach& here) const {
    std::array<bool, 2> is_held;
    for (int i = 0; i < 2; ++i) {
      is_held[static_cast<std::size_t>(i)] =
          (at[i] <= low_[i] && here.slope[i] > 0.0) || (at[i] >= high_[i] && here.slope[i] < 0.0);
    }
    if (is_held[0] && is_held[1]) return Vector2d::Zero();
    for (int i = 0; i < 2; ++i) {
      if (!is_held[static_cast<std::size_t>(1 - i)]) continue;
      Vector2d step = Vector2d::Zero();
      // Uphill of the bend's sign only the slope tells where to.
      const double bend = std::abs(here.bend(i, i));
      step[i] = bend > 0.0 ? -here.slope[i] / bend : -here.slope[i];
      return step;
    }
    // The eigenvalues by their size, and not too small: downhill whatever the bend. Parameters of
    // curves differ in their speed, so that they are scaled first.
    const Vector2d scale = here.bend.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt();
    const Matrix2d scaled = scale.asDiagonal().inverse() * here.bend * scale.asDiagonal().inverse();
    const Eigen::SelfAdjointEigenSolver<Matrix2d> modes(scaled);
    Vector2d sizes = modes.eigenvalues().cwiseAbs();
    // Beside a saddle a small eigenvalue would make a step of any length. Near a minimum all of
    // them stay, so that steps are Newton's own.
    if (modes.eigenvalues()[0] <= 0.0) {
      sizes = sizes.cwiseMax(kLeastSlope * sizes.maxCoeff());
    }
    // Where curves touch there is one that is rounding.
    sizes = sizes.cwiseMax(1e-14 * sizes.maxCoeff());
    const Vector2d slope = modes.eigenvectors().transpose() * here.slope.cwiseQuotient(scale);
    return -(modes.eigenvectors() * slope.cwiseQuotient(sizes)).cwiseQuotient(scale);
  }

  const NurbsCurve& first_;
  const NurbsCurve& second_;
  Vector2d low_, high_;
};

}  // namespace

std::array<double, 2> nearest_pair(const NurbsCurve& first, const NurbsCurve& second,
                                   std::array<double, 2> start) {
  const Vector2d at = PairDescent(first, second).run({start[0], start[1]});
  return {at[0], at[1]};
}

}  // namespace hull::network

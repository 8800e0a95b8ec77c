// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/bounded_minimum.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/dense_solvers.h"

namespace hull::modelling {
namespace {

using Sparse = BoundedMinimum::Sparse;

constexpr double kRegularisation = 1e-11;  // of the mean of M's diagonal
// Of the ratio of the traces of H and M: with a smaller p nothing but rounding is added.
constexpr double kLeastP = 1e-11, kMostP = 1e22;
constexpr double kLengthMet = 1e-12, kExcessMet = 1e-9;
constexpr int kMostChanges = 200;
// Of conditions' rows of unit length: less is left of one that others, or the limits, make up.
constexpr double kDependent = 1e-12;

double trace(const Sparse& matrix) { return matrix.diagonal().sum(); }

void check_independent(const Sparse& conditions) {
  if (conditions.rows() == 0) return;
  Eigen::MatrixXd unit = Eigen::MatrixXd(conditions);
  for (Eigen::Index i = 0; i < unit.rows(); ++i) {
    const double norm = unit.row(i).norm();
    if (norm > 0.0) unit.row(i) /= norm;
  }
  if (!mesh::are_independent(unit, kDependent)) {
    throw std::invalid_argument(
        "What is to be kept depends on one another, or on points that may not move: choose more "
        "points, or keep less.");
  }
}

}  // namespace

// The equations with one p.
class BoundedMinimum::System {
 public:
  System(const Sparse& mass, const Sparse& conditions) : mass_(mass), conditions_(conditions) {}

  // False where H + p M is not positive.
  bool factor(const Sparse& h, double p) {
    const Sparse matrix = h + p * mass_;
    // The matrices differ by p alone: one pattern, and one order of elimination.
    if (!is_analysed_) factors_.analyzePattern(matrix);
    is_analysed_ = true;
    factors_.factorize(matrix);
    if (factors_.info() != Eigen::Success) return false;
    if (conditions_.rows() == 0) return true;
    // The Schur complement of the conditions is C (H + p M)^-1 C^T: small, and dense.
    across_ = factors_.solve(Eigen::MatrixXd(conditions_.transpose()));
    small_.compute(conditions_ * across_);
    return small_.info() == Eigen::Success;
  }

  // x with (H + p M) x = right + Cᵀ λ and C x = d.
  Eigen::VectorXd solve(const Eigen::VectorXd& right, const Eigen::VectorXd& d) const {
    Eigen::VectorXd x = factors_.solve(right);
    if (conditions_.rows() > 0) x += across_ * small_.solve(d - conditions_ * x);
    return x;
  }

 private:
  const Sparse &mass_, &conditions_;
  Eigen::SimplicialLLT<Sparse> factors_;
  bool is_analysed_ = false;
  Eigen::MatrixXd across_;
  Eigen::LDLT<Eigen::MatrixXd> small_;
};

BoundedMinimum::BoundedMinimum(Sparse mass, const Sparse& conditions)
    : mass_(std::move(mass)), conditions_(conditions) {
  check_independent(conditions_);
  Sparse identity(mass_.rows(), mass_.cols());
  identity.setIdentity();
  mass_ += kRegularisation * trace(mass_) / static_cast<double>(mass_.rows()) * identity;
  // Told here once: shortest() takes it for granted.
  if (Eigen::SimplicialLLT<Sparse>(mass_).info() != Eigen::Success) {
    throw std::invalid_argument(
        "The surface is so uneven there that no move of it can be computed.");
  }
}

Eigen::VectorXd BoundedMinimum::shortest(const Eigen::VectorXd& d) const {
  System system(mass_, conditions_);
  system.factor(Sparse(mass_.rows(), mass_.cols()), 1.0);
  return system.solve(Eigen::VectorXd::Zero(mass_.rows()), d);
}

BoundedMinimum::Result BoundedMinimum::solve(
    const Sparse& h, const Eigen::VectorXd& g, const Eigen::VectorXd& d, double bound,
    const std::function<double(const Eigen::VectorXd&)>& excess) const {
  System system(mass_, conditions_);
  const double unit = trace(h) > 0.0 ? trace(h) / trace(mass_) : 1.0;
  const double most = kMostP * unit;
  double low = kLeastP * unit, high = most;  // too long at low, short enough at high
  double p = low;
  // What p tends to; it is the answer where the conditions leave nothing shorter.
  Result best{shortest(d), most, 0.0, true};
  best.length = std::sqrt(best.x.dot(mass_ * best.x));
  bool is_first = true;
  // Below the bound on the length, in logarithms: that of p, and of what is too large.
  double last_low = 0.0, last_high = 0.0;
  for (int step = 0; step < kMostChanges && high > low * (1.0 + 1e-15); ++step) {
    if (!system.factor(h, p)) {
      // H alone is singular to rounding, as where it tells nothing of some moves: p must be larger.
      low = p;
      p = is_first ? 10.0 * p : std::sqrt(low * high);
      continue;
    }
    const Eigen::VectorXd x = system.solve(-g, d);
    const Eigen::VectorXd weighed = mass_ * x;
    const double length = std::sqrt(x.dot(weighed));
    const double over = excess ? excess(x) : 0.0;
    const bool is_long = length > bound * (1.0 + kLengthMet), is_over = over > 1.0 + kExcessMet;
    if (!is_long && !is_over) {
      best = {x, p, length, !is_first};
      // The first is short enough with next to no p: nothing bounds it. Others end where either
      // bound is just met.
      if (is_first || length >= bound * (1.0 - kLengthMet) || over >= 1.0 - kExcessMet) break;
      high = p;
      last_high = std::log(std::max(length / bound, over));
    } else {
      low = p;
      last_low = std::log(std::max(length / bound, over));
    }
    is_first = false;
    // Newton's step where the length decides; otherwise a secant between both ends, or the middle.
    double next = 0.0;
    if (length / bound >= over) {
      // Minus length times the slope of the length by p; moves of x have no part in the conditions,
      // so d is 0 here.
      const double slope = weighed.dot(system.solve(weighed, Eigen::VectorXd::Zero(d.size())));
      next = p + length * length * (length - bound) / (bound * slope);
    } else if (high < most && last_low > 0.0 && last_high < 0.0 && step % 3 != 2) {
      // In logarithms, where both are nearly straight. Every third time the middle: a secant may
      // creep up on one end.
      const double share = last_low / (last_low - last_high);
      next = low * std::pow(high / low, share);
    } else if (high >= most) {
      // No p is known yet that is enough.
      next = p * std::max(2.0, over);
    }
    // Kept between what is known to be too little and enough, whatever Newton and the secant say.
    p = next > low && next < high ? next : std::sqrt(low * high);
  }
  return best;
}

}  // namespace hull::modelling

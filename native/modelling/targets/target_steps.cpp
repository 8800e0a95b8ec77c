// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modelling/targets/target_descent.h"

namespace hull::modelling {
namespace {

constexpr double kSettled = 1e-5;      // of the moves: a last step …
constexpr double kNearest = 1e-11;     // … and one where not all can be met
constexpr double kLeastMoves = 1e-13;  // of the mesh's size: moves that are none
constexpr double kLongestStep = 0.1;   // of the mesh's size, root mean square
constexpr double kSureDescent = 1e-4;  // of what the model promises
constexpr double kMostDamping = 1e12;  // beyond which a step is none
constexpr double kHeldFast = 1e30;     // price of the scaling's bounds

}  // namespace

void TargetDescent::linearise() {
  J_ = lengths_.cwiseInverse().asDiagonal() * problem_.by_moves();
  inverse_ = inverse_form(J_);
  K_.resize(J_.rows(), scales());
  const Eigen::MatrixX3d by_scale = problem_.by_scale();
  for (Eigen::Index k = 0; k < scales(); ++k) {
    K_.col(k) = by_scale.col(free_scales_[k]).cwiseQuotient(lengths_);
  }
  // Targets first, then the factors themselves.
  const Eigen::Index rows = J_.rows(), all = rows + scales();
  S_.setZero(all, all);
  // J H⁻¹ Jᵀ over moves and factors together; H of the factors is diagonal. Rows of the factors
  // have no part in the moves.
  S_.topLeftCorner(rows, rows) = J_ * inverse_;
  Eigen::MatrixXd by_factors(all, scales());
  by_factors.topRows(rows) = K_;
  by_factors.bottomRows(scales()).setIdentity();
  for (Eigen::Index k = 0; k < scales(); ++k) {
    S_ += by_factors.col(k) * by_factors.col(k).transpose() / scale_costs_[free_scales_[k]];
  }
  bounds_ = {Eigen::VectorXd(all), Eigen::VectorXd(all), Eigen::VectorXd(all)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    bounds_.low[i] = targets_[i].low / lengths_[i];
    bounds_.high[i] = targets_[i].high / lengths_[i];
    bounds_.most[i] = price_limit(i);
  }
  for (Eigen::Index k = 0; k < scales(); ++k) {
    const ScaleBounds& scale = options_.scales[free_scales_[k]];
    bounds_.low[rows + k] = scale.low;
    bounds_.high[rows + k] = scale.high;
    bounds_.most[rows + k] = kHeldFast;
  }
}

HullChange TargetDescent::step_from(const HullChange& from, const Eigen::VectorXd& values,
                                    double damping) {
  // Of ½ z'Hz + ½ damping (z - now)'H(z - now) the form is (1 + damping) H, and the least is at
  // this share of the way from nothing to now: so H is never factored again.
  const double share = damping / (1.0 + damping);
  HullChange middle = now_;  // least but for the conditions
  middle.y = share * now_.y;
  for (int k : free_scales_) middle.scale[k] = 1.0 + share * (now_.scale[k] - 1.0);
  const Eigen::Index rows = J_.rows();
  Eigen::VectorXd start(rows + scales());
  // The numbers at the middle, as they are linearised about `from`.
  start.head(rows) = values.cwiseQuotient(lengths_) + J_ * (middle.y - from.y);
  for (Eigen::Index k = 0; k < scales(); ++k) {
    const int axis = free_scales_[k];
    start.head(rows) += K_.col(k) * (middle.scale[axis] - from.scale[axis]);
    start[rows + k] = middle.scale[axis];
  }
  // What is missed costs no more than `most` a unit, so that targets which contradict one another
  // have a solution too.
  multipliers_ = bounded_dual(S_ / (1.0 + damping), start, bounds_);
  HullChange to = middle;
  to.y += inverse_ * multipliers_.head(rows) / (1.0 + damping);
  for (Eigen::Index k = 0; k < scales(); ++k) {
    const int axis = free_scales_[k];
    const double slope = K_.col(k).dot(multipliers_.head(rows)) + multipliers_[rows + k];
    const double scale = middle.scale[axis] + slope / scale_costs_[axis] / (1.0 + damping);
    // Bounds of factors have a price as well: this takes away what rounding leaves.
    to.scale[axis] = std::clamp(scale, options_.scales[axis].low, options_.scales[axis].high);
  }
  return to;
}

double TargetDescent::promised(const HullChange& to) const {
  Eigen::VectorXd values = values_ + (J_ * (to.y - now_.y)).cwiseProduct(lengths_);
  for (Eigen::Index k = 0; k < scales(); ++k) {
    const int axis = free_scales_[k];
    values += (to.scale[axis] - now_.scale[axis]) * K_.col(k).cwiseProduct(lengths_);
  }
  return cost(now_) + total_miss(values_) - cost(to) - total_miss(values);
}

bool TargetDescent::try_at(const HullChange& to, Eigen::VectorXd& values, int& fold) {
  fold = -1;
  try {
    problem_.place(to);
    values = problem_.values();
  } catch (const std::invalid_argument&) {
    return false;
  }
  fold = problem_.first_fold();
  return fold < 0 && values.allFinite();
}

bool TargetDescent::is_better(const HullChange& to, const Eigen::VectorXd& values,
                              double promise) const {
  const double gain = cost(now_) + total_miss(values_) - cost(to) - total_miss(values);
  return gain >= kSureDescent * promise;
}

TargetDescent::Step TargetDescent::take_step() {
  Step step;
  for (;; damping_ = std::max(4.0 * damping_, 0.25)) {
    if (damping_ > kMostDamping) break;
    HullChange to = step_from(now_, values_, damping_);
    const double way = length(to, now_);
    // Not worth a measure: so far away the numbers are not linear any longer.
    if (way > kLongestStep * size_) continue;
    const double moved =
        length(to, HullChange{Eigen::VectorXd::Zero(family_.size()), Vector3d::Ones()});
    const double settled = is_priced_out() ? kNearest : kSettled;
    const bool is_short = way <= settled * moved + kLeastMoves * size_;
    const double promise = promised(to);
    Eigen::VectorXd values;
    int fold = -1;
    bool is_sound = try_at(to, values, fold);
    bool is_good = is_sound && is_better(to, values, promise);
    if (is_sound && !is_good) {
      // The way the numbers curve, seen at the end of the step, taken into account.
      const Eigen::VectorXd multipliers = multipliers_;
      // A second-order correction, with the derivatives at `now_`: without it steps along a curved
      // condition would be refused however good they are (Maratos' effect).
      HullChange corrected = step_from(to, values, damping_);
      Eigen::VectorXd of_corrected;
      int other = -1;
      // A correction longer than the step itself tells of no curve.
      if (length(corrected, now_) <= 2.0 * way + kLeastMoves * size_ &&
          try_at(corrected, of_corrected, other) && is_better(corrected, of_corrected, promise)) {
        to = std::move(corrected);
        values = std::move(of_corrected);
        is_good = true;
      } else {
        multipliers_ = multipliers;
      }
    }
    // At the very end gain and promise are rounding.
    if (is_good || (is_sound && is_short && all_met(values))) {
      const bool is_undamped = damping_ == 0.0;
      now_ = std::move(to);
      values_ = std::move(values);
      damping_ = damping_ < 0.5 ? 0.0 : 0.25 * damping_;
      step.is_taken = true;
      // A step that only damping made short tells of no end.
      step.is_settled = is_short && (is_undamped || all_met(values_));
      step.fold = -1;
      return step;
    }
    step.fold = fold >= 0 ? fold : step.fold;
    if (is_short && damping_ == 0.0 && fold < 0) {
      step.is_settled = true;
      break;
    }
    // More damping makes no step that could be told from none.
    if (way <= kLeastMoves * size_) break;
  }
  problem_.place(now_);
  return step;
}

}  // namespace hull::modelling

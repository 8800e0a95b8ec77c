// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modelling/targets/target_descent.h"

namespace hull::modelling {
namespace {

constexpr double kMet = 1e-9;       // of a target's size
constexpr double kWaveMet = 1e-7;   // of a wave resistance, which is computed less exactly
constexpr double kMostPrice = 1e4;  // of the mesh's size: root mean square moves worth a miss
constexpr int kMostSteps = 100;

}  // namespace

TargetDescent::TargetDescent(const surface::LimitSurface& surface,
                             const std::vector<FormTarget>& targets, const TargetOptions& options,
                             const surface::Progress& progress)
    : targets_(targets),
      options_(options),
      progress_(progress),
      size_(surface.mesh().size()),
      family_(surface, options.limits, options.modes, options.stiffness, options.weights),
      problem_(surface, options.water, targets, family_) {
  check_scales();
  const std::array<double, 3> mean_squares = family_.mean_squares();
  for (int k = 0; k < 3; ++k) {
    if (options.scales[k].is_free()) free_scales_.push_back(k);
    scale_costs_[k] = options.scale_cost * mean_squares[k];
  }
  if (family_.size() == 0 && free_scales_.empty()) {
    throw std::invalid_argument("Nothing may move: free some points or a dimension.");
  }
  now_.y = Eigen::VectorXd::Zero(family_.size());
  for (int k = 0; k < 3; ++k) {
    const ScaleBounds& bounds = options.scales[k];
    // Where 1 is not within the limits the hull begins at the nearer one.
    now_.scale[k] = std::clamp(1.0, bounds.low, bounds.high);
  }
}

void TargetDescent::check_scales() const {
  bool is_any = false;
  for (const ScaleBounds& bounds : options_.scales) {
    if (!(bounds.low > 0.0) || !(bounds.low <= bounds.high) || !std::isfinite(bounds.high)) {
      throw std::invalid_argument(
          "The limits of a dimension's factor must be positive, the lower one first.");
    }
    is_any = is_any || bounds.low != 1.0 || bounds.high != 1.0;
  }
  if (!(options_.scale_cost > 0.0) || !std::isfinite(options_.scale_cost)) {
    throw std::invalid_argument("The cost of scaling must be positive.");
  }
  if (!is_any) return;
  if (options_.water.position.trim != 0.0) {
    throw std::invalid_argument("Dimensions can be free in water without trim only.");
  }
  if (!options_.limits.limits.locked.empty()) {
    throw std::invalid_argument(
        "Locked points cannot stay where a dimension is scaled: free them, or keep the "
        "dimensions.");
  }
}

TargetsReached TargetDescent::run() {
  TargetsReached result;
  // As the hull is, before dimensions are brought within their limits.
  const Eigen::VectorXd before = problem_.values();
  problem_.place(now_);
  values_ = problem_.values();
  // Once: sizes that went along with the derivatives would change what is made least.
  prepare_rows(before);
  // For the progress alone: where nothing is missed there is no division by zero.
  const double missing = std::max(total_miss(values_), 1e-300);
  result.status = TargetStatus::kUnsettled;
  while (result.iterations < kMostSteps) {
    ++result.iterations;
    linearise();
    const Step step = take_step();
    const double left = total_miss(values_) / missing;
    surface::tell(progress_, std::clamp(1.0 - left, 0.0, 1.0), 1.0);
    if (step.is_settled && all_met(values_)) {
      result.status = TargetStatus::kMet;
      break;
    }
    if (step.is_settled || !step.is_taken) {
      // A fold that stopped the way says more than what is missed because of it.
      result.status = step.fold >= 0                       ? TargetStatus::kFolded
                      : all_met(values_)                   ? TargetStatus::kMet
                      : step.is_settled || is_priced_out() ? TargetStatus::kUnreachable
                                                           : TargetStatus::kUnsettled;
      if (step.fold >= 0) result.folded_place = family_.places().position(step.fold);
      break;
    }
  }
  if (result.status == TargetStatus::kUnsettled && all_met(values_)) {
    result.status = TargetStatus::kMet;
  }
  take_outcome(before, result);
  return result;
}

void TargetDescent::prepare_rows(const Eigen::VectorXd& before) {
  const auto count = static_cast<Eigen::Index>(targets_.size());
  const Eigen::MatrixXd J = problem_.by_moves(), inverse = inverse_form(J);
  const Eigen::MatrixX3d by_scale = problem_.by_scale();
  lengths_.resize(count);
  met_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const FormTarget& target = targets_[i];
    // J H^-1 J^T: the square of what the number changes by at most for a shift of 1 m root mean
    // square, bending included.
    double square = J.row(i).dot(inverse.col(i));
    for (int k : free_scales_) square += std::pow(by_scale(i, k), 2) / scale_costs_[k];
    double wanted = std::abs(before[i]);
    for (double bound : {target.low, target.high}) {
      if (std::isfinite(bound)) wanted = std::max(wanted, std::abs(bound));
    }
    // What a hundredth of the ship's size changes it by, where all of it is about zero.
    const double by_shift = 0.01 * size_ * std::sqrt(square);
    // What nothing changes, such as a number of nothing immersed, has no such length: any will do
    // that makes its row a number.
    lengths_[i] = square > 0.0 ? std::sqrt(square) : std::max(wanted, 1.0) / size_;
    met_[i] =
        (target.wave_speed ? kWaveMet : kMet) * std::max({wanted, std::min(by_shift, 1.0), 1e-12});
  }
}

Eigen::MatrixXd TargetDescent::inverse_form(const Eigen::MatrixXd& J) const {
  if (family_.size() == 0) return Eigen::MatrixXd::Zero(0, J.rows());
  return family_.solve(J.transpose());
}

double TargetDescent::miss(Eigen::Index i, double value) const {
  return value - std::clamp(value, targets_[i].low, targets_[i].high);
}

bool TargetDescent::all_met(const Eigen::VectorXd& values) const {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!(std::abs(miss(i, values[i])) <= met_[i])) return false;
  }
  return true;
}

double TargetDescent::price_limit(Eigen::Index i) const {
  return kMostPrice * size_ * targets_[i].weight;
}

double TargetDescent::total_miss(const Eigen::VectorXd& values) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double far = std::abs(miss(i, values[i]));
    // An exact penalty: linear in the miss, so that beyond some price what can be met is met
    // exactly, not in proportion.
    if (far > met_[i]) sum += price_limit(i) * far / lengths_[i];
  }
  return sum;
}

double TargetDescent::cost(const HullChange& change) const {
  double sum = family_.cost(change.y);
  for (int k : free_scales_) {
    sum += 0.5 * scale_costs_[k] * std::pow(change.scale[k] - 1.0, 2);
  }
  return sum;
}

double TargetDescent::length(const HullChange& a, const HullChange& b) const {
  double sum = family_.cost(a.y - b.y);
  for (int k : free_scales_) {
    // A way, not a cost: by scaling as by moves it is the shift of the surface.
    sum += 0.5 * scale_costs_[k] / options_.scale_cost * std::pow(a.scale[k] - b.scale[k], 2);
  }
  // Costs are halves of mean squares.
  return std::sqrt(2.0 * sum);
}

bool TargetDescent::is_priced_out() const {
  for (Eigen::Index i = 0; i < J_.rows(); ++i) {
    if (std::abs(multipliers_[i]) >= 0.999 * price_limit(i)) return true;
  }
  return false;
}

void TargetDescent::take_outcome(const Eigen::VectorXd& before, TargetsReached& result) {
  const std::vector<Vector3d> points = problem_.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.moves.push_back(points[i] - problem_.start()[i]);
  }
  result.scale = now_.scale;
  for (Eigen::Index i = 0; i < values_.size(); ++i) {
    const double far = miss(i, values_[i]);
    // Multipliers are of rows by their lengths: of the number itself in its own unit this is left.
    const double price = multipliers_.size() > 0 ? multipliers_[i] / lengths_[i] : 0.0;
    result.targets.push_back({before[i], values_[i], std::abs(far) > met_[i] ? far : 0.0, price,
                              price_limit(i) / lengths_[i]});
  }
  for (Eigen::Index k = 0; k < scales() && multipliers_.size() > 0; ++k) {
    result.scale_prices[free_scales_[k]] = multipliers_[J_.rows() + k];
  }
  result.cost = cost(now_);
  const Eigen::VectorXd moves = family_.moves(now_.y);
  // The family's moves alone, without scaling.
  const VectorRows rows = family_.places().weights()->at(as_rows(moves));
  const Eigen::VectorXd shifts = rows.rowwise().squaredNorm();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < shifts.size(); ++k) {
    sum += shifts[k] * family_.places().area(static_cast<int>(k));
  }
  result.rms = std::sqrt(sum / family_.places().total_area());
}

TargetsReached reach_targets(const surface::LimitSurface& surface,
                             const std::vector<FormTarget>& targets, const TargetOptions& options,
                             const surface::Progress& progress) {
  return TargetDescent(surface, targets, options, progress).run();
}

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/shift_solver.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace hull::modelling {
namespace {

// Of coefficients, which are below 1. The model of the moment is quadratic: its differences are
// exact at any step, and what rounding leaves of them is least at large ones.
constexpr double kModelStep = 0.01;
constexpr int kNewtonSteps = 15;
constexpr int kMostModelSteps = 50;
// Of y: the model's root is found when a step is below it, as rounding lets no step be much shorter
// while y is of order 1.
constexpr double kModelMet = 1e-13;
// Of y: sections overtake one another at coefficients of order 1, so a root beyond it is of no use.
constexpr double kModelAstray = 1e3;
// Of kMet: steps go on to there, so that what is met is met whatever is rounded afterwards.
constexpr double kGoesOnTo = 0.01;

}  // namespace

SectionShift::Solver::Solver(SectionShift& shift, const FormTargets& targets)
    : shift_(shift), targets_(targets) {
  const bool has_numbers = (!targets.volume || std::isfinite(targets.volume->value)) &&
                           (!targets.lcb || std::isfinite(*targets.lcb));
  if (!has_numbers) throw std::invalid_argument("A wanted value is no number.");
  if (targets.volume) {
    wanted_volume_ = targets.volume->value / shift_.per_volume(targets.volume->measure);
  }
  choose_directions();
}

void SectionShift::Solver::choose_directions() {
  const int wanted = (targets_.volume ? 1 : 0) + (targets_.lcb ? 1 : 0);
  const int count = shift_.functions_.count();
  if (wanted > count) {
    throw std::invalid_argument(
        "One half of the body alone meets one wanted value: leave out the displacement or LCB, or "
        "shift both halves.");
  }
  // A alone for the volume alone, unless said otherwise below.
  directions_ = Eigen::MatrixXd::Identity(count, wanted);
  if (wanted != 1 || count != 2) return;
  if (shift_.functions_.part() == ShiftedPart::kApart) {
    // Both towards the ends, or both towards the bow.
    directions_ << 1.0, targets_.volume ? 1.0 : -1.0;
  } else if (targets_.lcb) {
    directions_ << 0.0, 1.0;
  }
}

std::vector<double> SectionShift::Solver::coefficients(const Vector& y) const {
  const Vector c = directions_ * y;
  return {c.data(), c.data() + c.size()};
}

SectionShift::Solver::Form SectionShift::Solver::form_at(const Vector& y) {
  shift_.hull_.move(shift_.moves(coefficients(y)));
  const analysis::Immersion& found = shift_.hull_.immersion();
  return {found.volume, found.volume * found.centre_of_buoyancy.x()};
}

void SectionShift::Solver::make_model() {
  const Eigen::Index n = directions_.cols();
  const auto at = [&](Eigen::Index i, double s, Eigen::Index j, double t) {
    Vector y = Vector::Zero(n);
    y[i] += s;
    y[j] += t;
    return form_at(y);
  };
  base_ = form_at(Vector::Zero(n));
  volume_slope_.setZero(n);
  moment_slope_.setZero(n);
  curvature_.setZero(n, n);
  const double h = kModelStep;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Form ahead = at(i, h, i, 0.0), behind = at(i, -h, i, 0.0);
    volume_slope_[i] = (ahead.volume - behind.volume) / (2.0 * h);
    moment_slope_[i] = (ahead.moment - behind.moment) / (2.0 * h);
    curvature_(i, i) = (ahead.moment - 2.0 * base_.moment + behind.moment) / (h * h);
  }
  for (Eigen::Index i = 1; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      // What a quadratic without the mixed term would have there is taken off.
      const double mixed = at(i, h, j, h).moment - base_.moment -
                           h * (moment_slope_[i] + moment_slope_[j]) -
                           0.5 * h * h * (curvature_(i, i) + curvature_(j, j));
      curvature_(i, j) = curvature_(j, i) = mixed / (h * h);
    }
  }
}

Eigen::MatrixXd SectionShift::Solver::model_slopes(const Vector& y) const {
  Eigen::MatrixXd slopes(directions_.cols(), directions_.cols());
  Eigen::Index row = 0;
  const double volume = model_volume(y);
  if (targets_.volume) slopes.row(row++) = volume_slope_.transpose() / base_.volume;
  if (targets_.lcb) {
    // LCB is moment over volume: the rule of quotients.
    const Vector lcb = (moment_slope_ + curvature_ * y) / volume -
                       volume_slope_ * (model_moment(y) / (volume * volume));
    slopes.row(row) = lcb.transpose() / shift_.project_.length_pp;
  }
  return slopes;
}

std::optional<Eigen::VectorXd> SectionShift::Solver::model_root(double volume, double lcb) const {
  Vector y = Vector::Zero(directions_.cols());
  for (int step = 0; step < kMostModelSteps; ++step) {
    Vector missing(y.size());
    Eigen::Index row = 0;
    const double now = model_volume(y);
    if (targets_.volume) missing[row++] = (volume - now) / base_.volume;
    if (targets_.lcb) missing[row] = (lcb - model_moment(y) / now) / shift_.project_.length_pp;
    // Newton's method on the model: no evaluation of the hull.
    const Vector change = model_slopes(y).fullPivLu().solve(missing);
    if (!change.allFinite()) return std::nullopt;
    y += change;
    if (y.norm() > kModelAstray) return std::nullopt;
    if (change.norm() < kModelMet) return y;
  }
  return std::nullopt;
}

Eigen::VectorXd SectionShift::Solver::missing(const Vector& y) {
  const Form form = form_at(y);
  Vector result(y.size());
  Eigen::Index row = 0;
  if (targets_.volume) {
    double wanted = wanted_volume_;
    if (targets_.volume->measure == VolumeMeasure::kPrismatic) {
      // The station amidships is another one after the shift.
      const double length = shift_.project_.length_pp;
      wanted = targets_.volume->value * shift_.hull_.section_area(0.5 * length) * length;
    }
    result[row++] = (wanted - form.volume) / base_.volume;
  }
  if (targets_.lcb) {
    result[row] = (*targets_.lcb - form.moment / form.volume) / shift_.project_.length_pp;
  }
  return result;
}

std::vector<double> SectionShift::Solver::solve() {
  if (directions_.cols() == 0) {
    const std::vector<double> none(shift_.functions_.count(), 0.0);
    if (!shift_.is_sound(none)) refuse();
    return none;
  }
  make_model();
  const std::optional<Vector> root = model_root(wanted_volume_, targets_.lcb.value_or(0.0));
  // Soundness is asked of the model's root, so that what is out of reach is told before the hull is
  // put there.
  if (!root || !is_sound(*root)) refuse();
  Vector y = *root, left = missing(y);
  Eigen::MatrixXd slopes = model_slopes(y);
  while (left.cwiseAbs().maxCoeff() > kGoesOnTo * kMet && iterations_ < kNewtonSteps) {
    const Vector step = slopes.fullPivLu().solve(left);
    const Vector next = y + step;
    if (!step.allFinite() || !is_sound(next)) refuse();
    const Vector now = missing(next);
    ++iterations_;
    if (!(now.norm() < left.norm())) break;  // rounding
    // Slopes are of what is met, so of minus what is missing.
    slopes += ((left - now) - slopes * step) * step.transpose() / step.squaredNorm();
    y = next;
    left = now;
  }
  converged_ = left.cwiseAbs().maxCoeff() <= kMet;
  return coefficients(y);
}

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/shift_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "modelling/transformation/smooth_step.h"

namespace hull::modelling {
namespace {

// x sin(πx) is extreme there, beyond x = 1: tan(πx) = -πx.
constexpr double kExtreme = 1.5639;
constexpr int kStretchSamples = 801;

// The cubic of t in [0, 1] with value and slope at 0, and neither at 1.
double faded(double value, double slope, double t) {
  const double s = std::min(t, 1.0), r = 1.0 - s;
  // Hermite's cubic; the slope is by t.
  return r * r * (value * (1.0 + 2.0 * s) + slope * s);
}

}  // namespace

ShiftFunctions::ShiftFunctions(const ShiftSettings& settings, const WorkingHull& hull,
                               const SurfacePlaces& places)
    : settings_(settings) {
  const double middle = 0.5 * settings.length_pp;
  parallel_ = settings.parallel.value_or(HullRange{middle, middle});
  check();
  if (settings.part == ShiftedPart::kWhole) {
    areas_.emplace(hull);
    area_at_ap_ = areas_->at(0.0);
    area_at_fp_ = areas_->at(settings.length_pp);
  }
  if (settings.part == ShiftedPart::kFair) fair_.emplace(fair_shifts(hull, places));
}

FairShifts ShiftFunctions::fair_shifts(const WorkingHull& hull, const SurfacePlaces& places) const {
  ShiftConstraints constraints{settings_.length_pp, {}, {}};
  if (settings_.parallel) constraints.rigid.push_back(*settings_.parallel);
  for (const HeldRange& held : settings_.held) {
    constraints.still.push_back({held.aft, held.forward});
  }
  const auto [aft, forward] = hull.immersed_range();
  return {AreaCurve(hull), {aft, forward}, places, constraints};
}

void ShiftFunctions::check() const {
  const double length = settings_.length_pp;
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw std::invalid_argument("Give Lpp: sections are shifted between the perpendiculars.");
  }
  const auto is_within = [length](const HullRange& range) {
    return range.aft > 0.0 && range.aft <= range.forward && range.forward < length;
  };
  if (!is_within(parallel_)) {
    throw std::invalid_argument(
        "The parallel middle body must lie between the perpendiculars, its aft end first.");
  }
  if (settings_.parallel_wanted) {
    if (!is_within(*settings_.parallel_wanted)) {
      throw std::invalid_argument(
          "The parallel middle body wanted must lie between the perpendiculars, its aft end "
          "first.");
    }
    if (!(parallel_.forward > parallel_.aft)) {
      throw std::invalid_argument(
          "There is no parallel middle body whose length could be changed: lengthen the hull where "
          "it is largest instead.");
    }
  }
  for (const HeldRange& held : settings_.held) {
    if (!(held.aft <= held.forward) || !(held.fade > 0.0) || !std::isfinite(held.fade) ||
        !std::isfinite(held.aft) || !std::isfinite(held.forward)) {
      throw std::invalid_argument(
          "A range that is kept runs from aft forward, and fades within a length above zero.");
    }
  }
}

double ShiftFunctions::towards_end(double x) const {
  const double half = 0.5 * settings_.length_pp;
  const bool is_fore = x > parallel_.forward;
  if (!is_fore && x >= parallel_.aft) return 0.0;
  const double room = is_fore ? settings_.length_pp - parallel_.forward : parallel_.aft;
  // 0 at the parallel body's end, 1 at the perpendicular.
  const double t = std::min((is_fore ? x - parallel_.forward : parallel_.aft - x) / room, kExtreme);
  // For a body without a parallel part room is the half length, and this half · x sin(π|x|).
  return (is_fore ? 1.0 : -1.0) * std::min(room, half) * t * std::sin(std::numbers::pi * t);
}

double ShiftFunctions::by_area(double x) const {
  const bool has_parallel = settings_.parallel.has_value();
  const double largest =
      // Not at an end itself: there must be room to fade on both sides.
      std::clamp(areas_->largest_position(), 0.1 * settings_.length_pp, 0.9 * settings_.length_pp);
  const double aft = has_parallel ? parallel_.aft : largest;
  const double fore = has_parallel ? parallel_.forward : largest;
  // In the parallel body all areas are the largest, whatever the spline makes of them.
  const double area = areas_->at(has_parallel && x > aft && x < fore ? fore : x);
  // From 0 at the largest section to 1 at the perpendiculars, so that by_area() is zero there.
  const double ahead = (x - fore) / (settings_.length_pp - fore), abaft = (aft - x) / aft;
  return area - area_at_fp_ * smooth_step(ahead) - area_at_ap_ * smooth_step(abaft);
}

double ShiftFunctions::freedom(double x) const {
  double share = 1.0;
  for (const HeldRange& held : settings_.held) {
    const double outside = std::max(held.aft - x, x - held.forward);
    // A product, so that ranges which overlap hold what either holds.
    share *= smooth_step(outside / held.fade);
  }
  return share;
}

double ShiftFunctions::value(int k, double x) const {
  const bool is_fore = x > parallel_.forward;
  double value = 0.0;
  switch (settings_.part) {
    case ShiftedPart::kWhole:
      value = k == 0 ? towards_end(x) : 0.5 * settings_.length_pp * by_area(x);
      break;
    case ShiftedPart::kApart:
      // Coefficient 0 is of the fore body, 1 of the aft body.
      value = is_fore == (k == 0) ? towards_end(x) : 0.0;
      break;
    case ShiftedPart::kFore:
      value = is_fore ? towards_end(x) : 0.0;
      break;
    case ShiftedPart::kAft:
      value = is_fore ? 0.0 : towards_end(x);
      break;
    case ShiftedPart::kFair:
      value = fair_->value(k, x);
      break;
  }
  return value * freedom(x);
}

double ShiftFunctions::parallel_change(double x) const {
  if (!settings_.parallel_wanted) return 0.0;
  const HullRange &now = parallel_, &wanted = *settings_.parallel_wanted;
  const double fore = wanted.forward - now.forward, aft = wanted.aft - now.aft;
  // The parallel body is stretched evenly; the ends go on with that slope, and fade to none at the
  // perpendiculars.
  const double slope = (fore - aft) / (now.forward - now.aft);
  const double ahead = settings_.length_pp - now.forward;
  double value = aft + slope * (x - now.aft);
  if (x > now.forward) value = faded(fore, slope * ahead, (x - now.forward) / ahead);
  if (x < now.aft) value = faded(aft, -slope * now.aft, (now.aft - x) / now.aft);
  return value * freedom(x);
}

Eigen::MatrixXd ShiftFunctions::slopes(double from, double to) const {
  const double step = 1e-6 * settings_.length_pp;
  const auto shift = [&](int column, double x) {
    return column == 0 ? parallel_change(x) : value(column - 1, x);
  };
  Eigen::MatrixXd slopes(2 * kStretchSamples, 1 + count());
  for (int i = 0; i < kStretchSamples; ++i) {
    const double x = from + (to - from) * i / (kStretchSamples - 1);
    for (int column = 0; column < slopes.cols(); ++column) {
      // One-sided: at the ends of halves and of the parallel body the slope may jump.
      const double here = shift(column, x);
      slopes(2 * i, column) = (shift(column, x + step) - here) / step;
      slopes(2 * i + 1, column) = (here - shift(column, x - step)) / step;
    }
  }
  return slopes;
}

double ShiftFunctions::least_stretch(const Eigen::MatrixXd& slopes,
                                     const std::vector<double>& coefficients) {
  Eigen::VectorXd factors(slopes.cols());
  factors[0] = 1.0;
  for (Eigen::Index k = 1; k < factors.size(); ++k) factors[k] = coefficients[k - 1];
  // Shifts are sums: one product tells of any coefficients, without the functions.
  return 1.0 + (slopes * factors).minCoeff();
}

}  // namespace hull::modelling

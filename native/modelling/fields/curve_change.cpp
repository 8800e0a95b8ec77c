// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/curve_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hull::modelling {
namespace {

// Of the curve's length: curves nearer than this are one.
constexpr double kSame = 1e-9;
// The stretch in common is looked for in so many steps, then to rounding.
constexpr int kSteps = 512;
constexpr int kBisections = 60;
// The slope takes this part of the stretch at most, from either end, to become what it is between.
constexpr double kWidest = 0.25;

// From 0 to 1 with two continuous derivatives, and its integral from 0.
double smooth_step(double x) { return x * x * x * (10.0 + x * (6.0 * x - 15.0)); }
double smooth_step_integral(double x) { return x * x * x * x * (2.5 + x * (x - 3.0)); }

// How far two curves are one, m: from their beginnings, or from their ends.
double common(const FieldCurve& a, const FieldCurve& b, bool from_end) {
  const double most = std::min(a.length(), b.length()), near = kSame * a.length();
  const auto at = [&](const FieldCurve& curve, double s) {
    return curve.point_at(from_end ? curve.length() - s : s);
  };
  const auto are_one = [&](double s) { return (at(a, s) - at(b, s)).norm() <= near; };
  if (!are_one(0.0)) return 0.0;
  int steps = 0;
  // From the beginning on, as what is in common must be without a gap.
  while (steps < kSteps && are_one(most * (steps + 1) / kSteps)) ++steps;
  if (steps == kSteps) return most;
  double low = most * steps / kSteps, high = most * (steps + 1) / kSteps;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    (are_one(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

CurveChange::CurveChange(FieldCurve curve, FieldCurve other)
    : curve_(std::move(curve)), other_(std::move(other)) {
  const double length = curve_.length(), other_length = other_.length();
  const double before = common(curve_, other_, false), ending = common(curve_, other_, true);
  // Where the curves cross again what is in common at the end is not that of the beginning, too.
  const double after = std::min({ending, length - before, other_length - before});
  begin_ = other_begin_ = before;
  end_ = length - after;
  other_end_ = other_length - after;
  const bool is_empty = end_ - begin_ <= kSame * length;
  const bool is_other_empty = other_end_ - other_begin_ <= kSame * length;
  if (is_empty && is_other_empty) {
    end_ = begin_;
    return;
  }
  if (is_empty || is_other_empty) {
    // One is the other but for a stretch that it lacks: nothing cannot become a stretch, nor a
    // stretch nothing, so that all of both takes part.
    begin_ = other_begin_ = 0.0;
    end_ = length;
    other_end_ = other_length;
  }
  // The slope between, 1 + c, is positive as long as the ways to it leave room.
  const double proportion = (other_end_ - other_begin_) / (end_ - begin_);
  const double width = std::min(kWidest, 0.5 * proportion);
  if (before > 0.0) rise_ = width;
  if (ending > 0.0) fall_ = width;
}

ValueAlong<double> CurveChange::mapped(double length) const {
  const double stretch = end_ - begin_, other_stretch = other_end_ - other_begin_;
  if (length < begin_) return {length, 1.0};
  if (length > end_ || !(end_ > begin_)) return {length - end_ + other_end_, 1.0};
  const double x = (length - begin_) / stretch, left = 1.0 - x;
  // What the slope is more than 1 by between: its integral over the stretch, ways up and down
  // included, is what the other stretch is longer by.
  const double c = (other_stretch / stretch - 1.0) / (1.0 - 0.5 * (rise_ + fall_));
  double slope = c, sum = c * (x - 0.5 * rise_);
  if (x < rise_) {
    slope = c * smooth_step(x / rise_);
    sum = c * rise_ * smooth_step_integral(x / rise_);
  } else if (left < fall_) {
    slope = c * smooth_step(left / fall_);
    sum = c * (1.0 - 0.5 * (rise_ + fall_) - fall_ * smooth_step_integral(left / fall_));
  }
  return {other_begin_ + stretch * (x + sum), 1.0 + slope};
}

ValueAlong<Vector3d> CurveChange::shift(double length) const {
  // Where a way up begins the curves are one but for rounding, which must not move anything; an end
  // that moves itself has its shift.
  if (!(end_ > begin_) || length < begin_ || length > end_ || (length == begin_ && rise_ > 0.0) ||
      (length == end_ && fall_ > 0.0)) {
    return {Vector3d::Zero(), Vector3d::Zero()};
  }
  const ValueAlong<double> to = mapped(length);
  return {other_.point_at(to.value) - curve_.point_at(length),
          other_.tangent_at(to.value) * to.slope - curve_.tangent_at(length)};
}

}  // namespace hull::modelling

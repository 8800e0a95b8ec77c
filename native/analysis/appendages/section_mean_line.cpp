// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/section_mean_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hull::analysis {
namespace {

constexpr double kMeeting = 1e-12;  // of the chord: where two parts meet
constexpr double kEvenLoad = 1e-6;  // a less than this from 1 is 1
constexpr double kNearTip = 1e-15;  // of the chord: where a slope is infinite
// With a = 1 the slope grows without end towards the trailing edge, and is no tangent for a cubic
// there.
constexpr double kHeldFrom = 1.0 - 1e-5;
constexpr double kNearFall = 1e-6;  // likewise of the curvature, where the load begins to fall
constexpr double kFirstStation = 0.005;
constexpr double kFiveDigitLift = 0.3;

// r and k1 of the mean lines 210 to 250, and of 221 to 251.
struct CubicLine {
  double r, k;
};
constexpr std::array<CubicLine, 5> kPlain{
    {{0.0580, 361.4}, {0.1260, 51.64}, {0.2025, 15.957}, {0.2900, 6.643}, {0.3910, 3.230}}};
constexpr std::array<CubicLine, 4> kReflexed{
    {{0.1300, 51.99}, {0.2170, 15.793}, {0.3180, 6.520}, {0.4410, 3.191}}};

// Of the 6A-series' a = 0.8.
constexpr double kA = 0.8, kShare = 0.97948, kStraightSlope = -0.24521;
constexpr double kBridge = 0.85, kStraightFrom = 0.9;

double square(double x) { return x * x; }
double cube(double x) { return x * x * x; }
// Of |x|, and finite at 0, where it is multiplied by zero.
double log_of(double x) {
  return std::log(std::max(std::abs(x), std::numeric_limits<double>::min()));
}

struct LoadTerms {
  double g, h;
};

// g and h of equation 4.26 of Abbott & Doenhoff (1959).
LoadTerms load_terms(double a) {
  const double rest = 1.0 - a;
  const double g = -(square(a) * (0.5 * log_of(a) - 0.25) + 0.25) / rest;
  return {g, g + rest * (0.5 * log_of(rest) - 0.25)};
}

}  // namespace

SectionMeanLine SectionMeanLine::four_digits(double highest, double place) {
  SectionMeanLine line;
  line.kind_ = Kind::kFourDigits;
  line.size_ = highest;
  line.place_ = place;
  return line;
}

SectionMeanLine SectionMeanLine::five_digits(double lift, int twentieths, bool is_reflexed) {
  const CubicLine& cubic = is_reflexed ? kReflexed[twentieths - 2] : kPlain[twentieths - 1];
  SectionMeanLine line;
  line.kind_ = Kind::kFiveDigits;
  line.size_ = lift / kFiveDigitLift * cubic.k;
  line.place_ = cubic.r;
  if (is_reflexed) {
    const double highest = 0.05 * twentieths;
    // k2 / k1, for which the moment about the quarter chord is zero.
    line.second_ = (3.0 * square(cubic.r - highest) - cube(cubic.r)) / cube(1.0 - cubic.r);
  }
  return line;
}

SectionMeanLine SectionMeanLine::loaded(double lift, double a) {
  SectionMeanLine line;
  line.kind_ = Kind::kLoaded;
  line.size_ = lift;
  // Equation 4.26 divides by 1 - a; at a = 1 its limit, 4.27, takes its place.
  line.place_ = 1.0 - a < kEvenLoad ? 1.0 : a;
  return line;
}

SectionMeanLine SectionMeanLine::loaded_6a(double lift) {
  SectionMeanLine line = loaded(kShare * lift, kA);
  line.kind_ = Kind::kLoaded6A;
  return line;
}

bool SectionMeanLine::is_behind(double x, double joint, bool behind) const {
  // At a joint, but for rounding of √x and its square, x does not tell the side: who asks does.
  return std::abs(x - joint) < kMeeting ? behind : x > joint;
}

double SectionMeanLine::height(double x) const {
  const double p = place_;
  switch (kind_) {
    case Kind::kStraight:
      return 0.0;
    case Kind::kFourDigits:
      if (x < p) return size_ / square(p) * x * (2.0 * p - x);
      return size_ / square(1.0 - p) * (1.0 - 2.0 * p + x * (2.0 * p - x));
    case Kind::kFiveDigits: {
      // One formula for both parts, with k2 / k1 before the cubic term behind r; 0 makes that
      // straight.
      const double bow = (x < p ? 1.0 : second_) * cube(x - p);
      return size_ / 6.0 * (bow - second_ * cube(1.0 - p) * x + cube(p) * (1.0 - x));
    }
    case Kind::kLoaded:
      return loaded_height(x);
    case Kind::kLoaded6A:
      // size_ is the share of the lift that the loaded line has; the slope was published for all of
      // it.
      if (x <= kBridge) return loaded_height(x);
      return x < kStraightFrom ? bridge_height(x) : size_ / kShare * kStraightSlope * (x - 1.0);
  }
  return 0.0;
}

std::array<double, 2> SectionMeanLine::slopes(double x, bool behind) const {
  switch (kind_) {
    case Kind::kStraight:
      return {0.0, 0.0};
    case Kind::kFourDigits:
      return four_digit_slopes(x, behind);
    case Kind::kFiveDigits:
      return five_digit_slopes(x, behind);
    case Kind::kLoaded:
      return loaded_slopes(x);
    case Kind::kLoaded6A:
      if (!is_behind(x, kBridge, behind)) return loaded_slopes(x);
      if (!is_behind(x, kStraightFrom, behind)) return bridge_slopes(x);
      return {size_ / kShare * kStraightSlope, 0.0};
  }
  return {0.0, 0.0};
}

std::array<double, 2> SectionMeanLine::held_slopes(double x, bool behind) const {
  return slopes(kind_ == Kind::kLoaded ? std::min(x, kHeldFrom) : x, behind);
}

std::array<double, 2> SectionMeanLine::perpendicular_slopes(double x, bool behind) const {
  const bool is_loaded = kind_ == Kind::kLoaded || kind_ == Kind::kLoaded6A;
  if (!is_loaded || x >= kFirstStation) return held_slopes(x, behind);
  const auto [slope, bend] = loaded_slopes(kFirstStation);
  return {slope + bend * (x - kFirstStation), bend};
}

std::vector<double> SectionMeanLine::joints() const {
  if (kind_ == Kind::kLoaded6A) return {kA, kBridge, kStraightFrom};
  if (place_ > 0.0 && place_ < 1.0) return {place_};
  return {};
}

std::array<double, 2> SectionMeanLine::four_digit_slopes(double x, bool behind) const {
  const bool after = is_behind(x, place_, behind);
  const double factor = 2.0 * size_ / square(after ? 1.0 - place_ : place_);
  return {factor * (place_ - x), -factor};
}

std::array<double, 2> SectionMeanLine::five_digit_slopes(double x, bool behind) const {
  const double bow = size_ * (is_behind(x, place_, behind) ? second_ : 1.0);
  return {
      0.5 * bow * square(x - place_) - size_ / 6.0 * (second_ * cube(1.0 - place_) + cube(place_)),
      bow * (x - place_)};
}

double SectionMeanLine::loaded_height(double x) const {
  const double a = place_, rest = 1.0 - x, factor = size_ / (2.0 * std::numbers::pi * (a + 1.0));
  if (a == 1.0) return -factor * (rest * log_of(rest) + x * log_of(x));
  const auto [g, h] = load_terms(a);
  // The terms of equation 4.26 in 1 / (1 - a), gathered: each is z² (ln z / 2 - 1 / 4).
  const double loads =
      square(a - x) * (0.5 * log_of(a - x) - 0.25) - square(rest) * (0.5 * log_of(rest) - 0.25);
  return factor * (loads / (1.0 - a) - x * log_of(x) + g - h * x);
}

std::array<double, 2> SectionMeanLine::loaded_slopes(double x) const {
  const double a = place_, factor = size_ / (2.0 * std::numbers::pi * (a + 1.0));
  x = std::max(x, kNearTip);
  if (a == 1.0) {
    x = std::min(x, 1.0 - kNearTip);
    return {factor * (log_of(1.0 - x) - log_of(x)), -factor * (1.0 / (1.0 - x) + 1.0 / x)};
  }
  // At a and at 1 the slope is finite, but the curvature has a logarithm: it is held beside them.
  const double rest = std::max(1.0 - x, kNearFall), before = a - x;
  const double near = std::max(std::abs(before), kNearFall);
  const double loads = rest * log_of(rest) - before * log_of(before);
  return {factor * (loads / (1.0 - a) - 1.0 - log_of(x) - load_terms(a).h),
          factor * (std::log(near / rest) / (1.0 - a) - 1.0 / x)};
}

double SectionMeanLine::bridge_height(double x) const {
  const double h = kStraightFrom - kBridge, t = (x - kBridge) / h, q = 1.0 - t;
  const double from = loaded_height(kBridge), slope = loaded_slopes(kBridge)[0];
  const double tail = size_ / kShare * kStraightSlope, to = tail * (kStraightFrom - 1.0);
  // Hermite's cubic between the curve's end and the straight line, with the slopes of both.
  return square(q) * (1.0 + 2.0 * t) * from + square(t) * (1.0 + 2.0 * q) * to +
         h * t * q * (q * slope - t * tail);
}

std::array<double, 2> SectionMeanLine::bridge_slopes(double x) const {
  const double h = kStraightFrom - kBridge, t = (x - kBridge) / h, q = 1.0 - t;
  const double slope = loaded_slopes(kBridge)[0], tail = size_ / kShare * kStraightSlope;
  const double rise = (tail * (kStraightFrom - 1.0) - loaded_height(kBridge)) / h;
  return {6.0 * t * q * rise + q * (1.0 - 3.0 * t) * slope - t * (2.0 - 3.0 * t) * tail,
          (6.0 * (q - t) * rise + (6.0 * t - 4.0) * slope + (6.0 * t - 2.0) * tail) / h};
}

}  // namespace hull::analysis

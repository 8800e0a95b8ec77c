// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hull::drawing {

namespace {

constexpr double kSlack = 1e-6;  // of a step: ends that are ticks but for rounding

struct Mantissa {
  double value;
  int parts;
};
constexpr std::array<Mantissa, 3> kUsual{{{1.0, 5}, {2.0, 4}, {5.0, 5}}};
// Axes that share a grid can't choose how many steps they have, so they get one more size of step,
// to leave less room unused.
constexpr std::array<Mantissa, 4> kDivided{{{1.0, 5}, {2.0, 4}, {2.5, 5}, {5.0, 5}}};

int power_of_ten(double value) { return static_cast<int>(std::floor(std::log10(value))); }

// Not pow alone: its negative powers are not the doubles nearest to 0.1, 0.01, ...
double ten_to(int power) {
  return power < 0 ? 1.0 / std::pow(10.0, -power) : std::pow(10.0, power);
}

// Decimals with which multiples of `step` are written in full: 0 for 20, 1 for 2.5, 2 for 0.05.
int decimals_of(double step) {
  // From one decimal less than the size of the step needs, as its logarithm may be rounded to the
  // next power.
  for (int decimals = std::max(0, -power_of_ten(step) - 1);; ++decimals) {
    const double scaled = step * ten_to(decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled || decimals > 12) return decimals;
  }
}

int exponent_of(const PlotRange& range) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  // Usual sizes are written out; others are in powers of a thousand, as units are.
  if (size >= 1e-2 && size < 1e6) return 0;
  return 3 * static_cast<int>(std::floor(power_of_ten(size) / 3.0));
}

AxisScale scale(const PlotRange& range, double step, int parts) {
  return {range.low, range.high, step, parts, exponent_of(range)};
}

// Adding zero turns a negative zero into one without sign.
double at_multiple(double count, double part) { return count * part + 0.0; }

}  // namespace

std::vector<double> AxisScale::multiples_of(double part) const {
  std::vector<double> all;
  // Counted and multiplied: a sum of steps would drift.
  const double first = std::ceil(low / part - kSlack);
  const double last = std::floor(high / part + kSlack);
  for (double count = first; count <= last; count += 1.0) all.push_back(at_multiple(count, part));
  return all;
}

std::string AxisScale::text(double tick) const {
  const double unit = ten_to(exponent);
  // A number that is zero but for rounding would be "-0".
  const double shown = std::abs(tick) < kSlack * step ? 0.0 : tick / unit;
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals_of(step / unit), shown);
  std::string text = digits;
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

std::string AxisScale::unit_text(const std::string& unit) const {
  if (exponent == 0) return unit;
  static constexpr std::array<const char*, 10> kRaised{"⁰", "¹", "²", "³", "⁴",
                                                       "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += kRaised[digit - '0'];
  return unit.empty() ? text : text + " " + unit;
}

PlotRange widened(PlotRange data, bool from_zero) {
  if (from_zero) data = {std::min(data.low, 0.0), std::max(data.high, 0.0)};
  const double size = std::max(std::abs(data.low), std::abs(data.high));
  if (size < 1e-100) return {0.0, 1.0};
  const double least = 1e-9 * size;
  if (data.high - data.low >= least) return data;
  // What differs by no more than rounding gets a billionth of its size, a single number a tenth of
  // it.
  const double margin = data.high > data.low ? least : 0.1 * size;
  return {data.low - margin, data.high + margin};
}

AxisScale exact_scale(const PlotRange& range, int most_steps) {
  const double wanted = (range.high - range.low) / most_steps;
  for (int power = power_of_ten(wanted);; ++power) {
    // They rise, and after 5 comes 1 of the next power: the first that is large enough is the
    // finest.
    for (const Mantissa& mantissa : kUsual) {
      const double step = mantissa.value * ten_to(power);
      if (step >= wanted * (1.0 - kSlack)) return scale(range, step, mantissa.parts);
    }
  }
}

AxisScale rounded_scale(const PlotRange& range, int most_steps) {
  AxisScale found = exact_scale(range, most_steps);
  const double part = found.step / found.parts;
  found.low = at_multiple(std::floor(range.low / part + kSlack), part);
  found.high = at_multiple(std::ceil(range.high / part - kSlack), part);
  // An end may have been rounded up to the next power of ten.
  found.exponent = exponent_of({found.low, found.high});
  return found;
}

AxisScale divided_scale(const PlotRange& range, int steps) {
  const double wanted = (range.high - range.low) / steps;
  // Ends where two steps or more are asked for: at the latest with a step as large as the range is
  // on either side of zero, from -step to +step.
  for (int power = power_of_ten(wanted);; ++power) {
    for (const Mantissa& mantissa : kDivided) {
      const double step = mantissa.value * ten_to(power);
      // Part of the first step is lost below the range. Where the last one then ends too low, the
      // next size is tried.
      const double first = std::floor(range.low / step + kSlack);
      const PlotRange whole{at_multiple(first, step), at_multiple(first + steps, step)};
      if (step >= wanted * (1.0 - kSlack) && whole.high >= range.high - kSlack * step) {
        return scale(whole, step, mantissa.parts);
      }
    }
  }
}

}  // namespace hull::drawing

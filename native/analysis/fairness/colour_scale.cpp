// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace hull::analysis {
namespace {

constexpr double kNearZero = 1e-3;  // of the range: where the logarithmic scale becomes linear
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kMostColours = 8;

using Weighted = std::array<double, 2>;  // value, weight

// The value that `part` of the weights do not exceed.
double quantile(const std::vector<Weighted>& sorted, double part) {
  double total = 0.0;
  for (const auto& [value, weight] : sorted) total += weight;
  double sum = 0.0;
  for (const auto& [value, weight] : sorted) {
    sum += weight;
    if (sum >= part * total) return value;
  }
  return sorted.back()[0];
}

// The least of 1, 2, 5 times a power of ten that is not below the number.
double round_up(double number) {
  const double power = std::pow(10.0, std::floor(std::log10(number)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= number * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::string label_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// From a value to the legend's unit.
double legend_factor(FieldKind kind) {
  constexpr double kMillimetres = 1000.0;
  if (kind == FieldKind::kSlope) return kDegrees;
  return kind == FieldKind::kDistance ? kMillimetres : 1.0;
}

}  // namespace

ColourScale::ColourScale(FieldKind kind, Mapping mapping, double low, double high)
    : kind_(kind), mapping_(mapping), low_(low), high_(high) {
  if (!(low < high) || !std::isfinite(low) || !std::isfinite(high)) {
    throw std::invalid_argument("The limits of a colour scale must rise and be finite, not " +
                                std::to_string(low) + " and " + std::to_string(high) + ".");
  }
  if (is_signed()) {
    high_ = std::max(-low, high);
    // Zero in the middle, or hollow and full would not be told apart by their colours.
    low_ = -high_;
  }
}

ColourScale ColourScale::fit(const std::vector<double>& values, const std::vector<double>& weights,
                             FieldKind kind, Mapping mapping, double part) {
  if (!weights.empty() && weights.size() != values.size()) {
    throw std::invalid_argument("There are " + std::to_string(weights.size()) + " weights for " +
                                std::to_string(values.size()) + " values.");
  }
  if (!(part > 0.0 && part <= 1.0)) {
    throw std::invalid_argument(
        "The part of the surface that a colour scale covers is above 0 and at most 1, not " +
        std::to_string(part) + ".");
  }
  const bool is_signed = kind != FieldKind::kSlope;
  std::vector<Weighted> sorted;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    // To both sides of zero alike.
    sorted.push_back({is_signed ? std::abs(values[i]) : values[i],
                      weights.empty() ? 1.0 : std::max(weights[i], 0.0)});
  }
  std::sort(sorted.begin(), sorted.end());
  if (is_signed) {
    double high = sorted.empty() ? 0.0 : quantile(sorted, part);
    // Where most is flat, what is not counts all the same.
    if (!(high > 0.0) && !sorted.empty()) high = sorted.back()[0];
    if (!(high > 0.0)) high = 1.0;
    return {kind, mapping, -high, high};
  }
  if (sorted.empty()) return {kind, mapping, 0.0, std::numbers::pi};
  const double low = quantile(sorted, 0.5 * (1.0 - part));
  const double high = quantile(sorted, 0.5 * (1.0 + part));
  // A flat has one slope everywhere, and a scale some range.
  constexpr double kLeastRange = 1e-6;
  return {kind, mapping, low, std::max(high, low + kLeastRange)};
}

std::string ColourScale::unit() const {
  if (kind_ == FieldKind::kSlope) return "°";
  if (kind_ == FieldKind::kDistance) return "mm";
  return kind_ == FieldKind::kGaussian ? "1/m²" : "1/m";
}

double ColourScale::position(double value) const {
  if (std::isnan(value)) return value;
  value = std::clamp(value, low_, high_);
  if (mapping_ == Mapping::kLinear) return (value - low_) / (high_ - low_);
  if (is_signed()) {
    return 0.5 + 0.5 * std::asinh(value / (kNearZero * high_)) / std::asinh(1.0 / kNearZero);
  }
  const double along = (value - low_) / (high_ - low_);
  return std::log1p(along / kNearZero) / std::log1p(1.0 / kNearZero);
}

Colour ColourScale::colour_at(double position) const {
  if (std::isnan(position)) return kNoValueColour;
  return is_signed() ? diverging_colour(position) : sequential_colour(position);
}

void ColourScale::add_tick(double value, std::vector<Tick>& ticks) const {
  const double factor = legend_factor(kind_);
  ticks.push_back({value, position(value / factor), label_of(value)});
}

std::vector<ColourScale::Tick> ColourScale::ticks() const {
  std::vector<Tick> ticks;
  const double factor = legend_factor(kind_);
  if (mapping_ == Mapping::kLogarithmic && is_signed()) {
    // The range itself may be a power of ten, but for rounding.
    const int top = static_cast<int>(std::floor(std::log10(factor * high_) + 1e-9));
    constexpr int kDecades = 3;
    for (int k = 0; k < kDecades; ++k) add_tick(-std::pow(10.0, top - k), ticks);
    add_tick(0.0, ticks);
    for (int k = kDecades - 1; k >= 0; --k) add_tick(std::pow(10.0, top - k), ticks);
    return ticks;
  }
  const double low = factor * low_, high = factor * high_;
  const double step = round_up((high - low) / kMostColours);
  // Multiples of the step, since sums of it would drift, and miss zero.
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0) {
    add_tick(k * step, ticks);
  }
  return ticks;
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/plan_lengths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hull::drawing {

namespace {

constexpr double kFoot = 0.3048, kInch = 0.0254;
constexpr long kSixteenths = 192;  // of an inch, in a foot

std::string in_feet_inches_eighths(double metres) {
  // Rounded once, in sixteenths: so twelve inches or eight eighths are never written.
  const long count = std::lround(std::abs(metres) / kFoot * kSixteenths);
  const long sixteenths = count % 16;
  // No sign before nothing.
  std::string text = metres < 0.0 && count != 0 ? "-" : "";
  text += std::to_string(count / kSixteenths) + "-" + std::to_string(count % kSixteenths / 16);
  // Eighths; an odd sixteenth is the plus.
  text += "-" + std::to_string(sixteenths / 2);
  return sixteenths % 2 == 0 ? text : text + "+";
}

}  // namespace

double metres_of(LengthUnit unit) { return unit == LengthUnit::kMetre ? 1.0 : kFoot; }

std::string symbol_of(LengthUnit unit) { return unit == LengthUnit::kMetre ? "m" : "ft"; }

std::string plural_of(LengthUnit unit) { return unit == LengthUnit::kMetre ? "metres" : "feet"; }

int decimals_of(const std::vector<double>& metres, LengthUnit unit) {
  for (int decimals = 1; decimals < 3; ++decimals) {
    const double step = std::pow(10.0, -decimals);
    const auto is_told = [step, unit](double length) {
      const double value = length / metres_of(unit);
      // Half of the last unit that three decimals tell.
      return std::abs(std::round(value / step) * step - value) <= 5e-4;
    };
    if (std::all_of(metres.begin(), metres.end(), is_told)) return decimals;
  }
  return 3;
}

std::string length_text(double metres, int decimals, LengthUnit unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, metres / metres_of(unit));
  return std::string(text) + " " + symbol_of(unit);
}

std::string spacing_text(double metres, LengthUnit unit) {
  char text[64];
  if (unit == LengthUnit::kMetre) {
    std::snprintf(text, sizeof text, "%.6g mm", 1000.0 * metres);
  } else {
    std::snprintf(text, sizeof text, "%.6g in", metres / kInch);
  }
  return text;
}

std::string without_unit(const std::string& text, LengthUnit unit) {
  const std::string end = " " + symbol_of(unit);
  return text.ends_with(end) ? text.substr(0, text.size() - end.size()) : text;
}

std::string offset_text(double metres, LengthUnit unit) {
  if (std::isnan(metres)) return "–";
  if (unit == LengthUnit::kFoot) return in_feet_inches_eighths(metres);
  return std::to_string(std::lround(1000.0 * metres));
}

std::string offsets_unit(LengthUnit unit) {
  return unit == LengthUnit::kMetre ? "mm" : "feet-inches-eighths";
}

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
// What a SectionShift can reach, and the words that say so.
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "modelling/transformation/shift_solver.h"

namespace hull::modelling {
namespace {

// First steps from the present value, of the volume and of Lpp: less is no shift a designer asks
// for, and what can be reached mostly is some doublings away.
constexpr double kVolumeStep = 1e-3, kLcbStep = 1e-4;
// So many doublings come to more than a thousand times the volume, or Lpp: no form is that far off.
constexpr int kMostDoublings = 24;
// Halvings of the last doubling: to 6e-8 of it, beyond the digits that are told.
constexpr int kReachBisections = 24;
// Of a number's text: six digits with sign, point and exponent are a fifth of it.
constexpr int kTextSize = 64;

struct Words {
  const char* name;
  const char* unit;
  const char* format;
};

Words words_of(VolumeMeasure measure) {
  switch (measure) {
    case VolumeMeasure::kVolume:
      return {"∇", " m³", "%.6g"};
    case VolumeMeasure::kDisplacement:
      return {"Δ", " t", "%.6g"};
    case VolumeMeasure::kBlock:
      return {"Cb", "", "%.4f"};
    case VolumeMeasure::kPrismatic:
      return {"Cp", "", "%.4f"};
  }
  return {"", "", "%g"};
}

std::string number(const char* format, double value) {
  char text[kTextSize];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string between(const Words& words, double low, double high) {
  return std::string(words.name) + " can be " + number(words.format, low) + words.unit + " to " +
         number(words.format, high) + words.unit;
}

}  // namespace

template <class Path>
std::optional<SectionShift::Solver::Range> SectionShift::Solver::reach(const Path& path,
                                                                       double start,
                                                                       double step) const {
  const auto is_reached = [&](double value) {
    const std::optional<Vector> y = path(value);
    return y && is_sound(*y);
  };
  if (!is_reached(start)) return std::nullopt;
  const auto end = [&](double direction) {
    double inside = start, distance = step;
    for (int i = 0; i < kMostDoublings && is_reached(start + direction * distance); ++i) {
      inside = start + direction * distance;
      distance *= 2.0;
    }
    // Between the last value that is reached and the first that is not: what lies behind a gap is
    // not looked for.
    double outside = start + direction * distance;
    for (int i = 0; i < kReachBisections; ++i) {
      const double middle = 0.5 * (inside + outside);
      (is_reached(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  return Range{end(-1.0), end(1.0)};
}

std::string SectionShift::Solver::volume_range(const Range& range) const {
  const double factor = shift_.per_volume(targets_.volume->measure);
  return between(words_of(targets_.volume->measure), factor * range.low, factor * range.high);
}

std::string SectionShift::Solver::lcb_range(const Range& range) const {
  return between({"LCB", " m", "%.6g"}, range.low, range.high);
}

void SectionShift::Solver::refuse() {
  if (directions_.cols() == 0 || !is_sound(Vector::Zero(directions_.cols()))) {
    throw std::invalid_argument(
        "The parallel middle body wanted leaves too little room for the ends: sections would "
        "overtake one another.");
  }
  // solve() has made the model by then.
  const double present = base_.moment / base_.volume;
  const auto volumes =
      reach([&](double volume) { return model_root(volume, targets_.lcb.value_or(0.0)); },
            base_.volume, kVolumeStep * base_.volume);
  const auto lcbs = reach([&](double lcb) { return model_root(base_.volume, lcb); }, present,
                          kLcbStep * shift_.project_.length_pp);
  if (targets_.volume && volumes) {
    std::string text = volume_range(*volumes) + " here";
    if (targets_.lcb) text += " with LCB at " + number("%.6g", *targets_.lcb) + " m";
    throw std::invalid_argument(text + ": beyond, sections would overtake one another.");
  }
  if (targets_.lcb && lcbs) {
    std::string text = lcb_range(*lcbs) + " from the after perpendicular here";
    if (targets_.volume) text += " with the present displacement";
    throw std::invalid_argument(text + ": beyond, sections would overtake one another.");
  }
  throw std::invalid_argument(
      "What is wanted is out of reach: shifts of these sections change neither displacement nor "
      "LCB enough.");
}

}  // namespace hull::modelling

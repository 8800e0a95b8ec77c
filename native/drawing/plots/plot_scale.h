// SPDX-License-Identifier: GPL-3.0-or-later
// Which numbers stand along an axis.
#pragma once

#include <string>
#include <vector>

#include "drawing/plots/plot.h"

namespace hull::drawing {

// The ticks are the multiples of `step` from `low` to `high`; `step` is 1, 2, 2.5 or 5 times a
// power of ten.
struct AxisScale {
  double low, high;
  double step;
  int parts;     // into how many finer steps a step divides
  int exponent;  // the numbers at the ticks are in units of ten to this power; 0 for usual sizes

  std::vector<double> ticks() const { return multiples_of(step); }
  std::vector<double> fine_ticks() const { return multiples_of(step / parts); }
  std::string text(double tick) const;

  // "m³", or "10⁶ m³" when the numbers are in such units.
  std::string unit_text(const std::string& unit) const;

  // 0 at low, 1 at high.
  double position(double value) const { return (value - low) / (high - low); }

 private:
  std::vector<double> multiples_of(double part) const;
};

// What an axis must show: `data` with zero where it is wanted, made wider where it is narrower than
// a billionth of its size or a single number. REQUIRES: finite; low <= high.
PlotRange widened(PlotRange data, bool from_zero);

// At most `most_steps` steps; the ends are the next finer steps outside `range`.
// REQUIRES: most_steps >= 1; a range as from `widened`.
AxisScale rounded_scale(const PlotRange& range, int most_steps);

// The same without moving the ends.
AxisScale exact_scale(const PlotRange& range, int most_steps);

// Exactly `steps` steps, the first tick at the low end.
AxisScale divided_scale(const PlotRange& range, int steps);

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fairness/colour_maps.h"
#include "analysis/fairness/surface_field.h"

namespace hull::analysis {

// From values of a field to colours, and back to a legend.
//
// Curvatures and distances have a sign: 0 is in the middle of the scale, at position 0.5, and the
// range is as wide to both sides. A slope runs from its least to its greatest value. Values beyond
// the range have the colours of its ends.
class ColourScale {
 public:
  enum class Mapping {
    kLinear,
    // Of a signed field: asinh(v / v0), v0 = range / 1000: nearly linear below v0, then as the
    // logarithm. Of others the logarithm of 1 + (v - low) / v0.
    kLogarithmic
  };

  // The range from the values: what `part` of the area, or of the values without `weights`, stays
  // within; of a slope, but for (1 - part) / 2 at both ends. Values that are not finite do not
  // count. Throws std::invalid_argument for weights of another length than the values, or a part
  // outside of (0, 1].
  static ColourScale fit(const std::vector<double>& values, const std::vector<double>& weights,
                         FieldKind kind, Mapping mapping, double part);
  // For a signed field the range is made as wide to both sides. Throws std::invalid_argument unless
  // low < high, both finite.
  ColourScale(FieldKind kind, Mapping mapping, double low, double high);

  FieldKind kind() const { return kind_; }
  Mapping mapping() const { return mapping_; }
  double low() const { return low_; }
  double high() const { return high_; }
  bool is_signed() const { return kind_ != FieldKind::kSlope; }
  // Of the legend: "1/m²", "1/m", "°", or of distances "mm".
  std::string unit() const;

  // In [0, 1]; NaN where the value is.
  double position(double value) const;
  Colour colour_at(double position) const;
  Colour colour(double value) const { return colour_at(position(value)); }

  struct Tick {
    double value;     // in the legend's unit: a round number
    double position;  // in [0, 1]
    std::string label;
  };
  // From low to high: 4 to 11 of them.
  std::vector<Tick> ticks() const;

 private:
  void add_tick(double value, std::vector<Tick>& ticks) const;

  FieldKind kind_;
  Mapping mapping_;
  double low_, high_;
};

}  // namespace hull::analysis

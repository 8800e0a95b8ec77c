// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/appendages/section_mean_line.h"
#include "analysis/appendages/section_thickness.h"

namespace hull::analysis {

// What the name of a NACA section says.
struct NamedSection {
  double largest;  // thickness, of the chord
  SectionThickness thickness;
  SectionMeanLine mean_line;
};

// "0012", "2412": camber in per cent, its place in tenths, thickness in per cent;
// "23012", "23112": lift coefficient in 0.15, place of the camber in twentieths, 1 where reflexed;
// "0012-64", "2412-34", "23012-64": nose and tenths as of SectionThickness::modified;
// "63-012", "64-215", "65(3)-218", "63-412 a=0.8", "64A010", "64A212": series with the range of low
// drag, which says nothing on the form, or without; lift coefficient in tenths, thickness; the mean
// line is a = 1, of 6A-series SectionMeanLine::loaded_6a, unless another is given.
// With "NACA " before it or without. Throws std::invalid_argument for what is no such name.
NamedSection section_named(const std::string& name);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/arithmetic/gauss.h"

namespace hull::conversion {

// Samples along [0, 1]: Gauss nodes of intervals, and both ends with the weight 0.
struct SampleLine {
  std::vector<double> at, weights;
  std::vector<int> intervals;  // of each sample
  int interval_count = 0;
};

// Rising and each once, with 0 and 1; numbers outside are left out, and of those that differ by
// rounding all but one.
std::vector<double> breaks_between(std::vector<double> numbers);

// Halves the first or the last interval again and again towards the end.
void refine_ends(std::vector<double>& breaks, bool at_begin, bool at_end);

SampleLine sample_line(const std::vector<double>& breaks, const analysis::GaussRule& rule);

}  // namespace hull::conversion

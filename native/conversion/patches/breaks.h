// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace hull::conversion {

inline constexpr double kSameBreak = 1e-12;  // closer parameters differ by rounding

// Adds a place inside (0, 1) where an edge is divided to others, rising.
inline void add_break(std::vector<double>& breaks, double t) {
  // At its ends an edge has vertices already.
  if (!(t > kSameBreak && t < 1.0 - kSameBreak)) return;
  const auto next = std::lower_bound(breaks.begin(), breaks.end(), t - kSameBreak);
  if (next == breaks.end() || *next > t + kSameBreak) breaks.insert(next, t);
}

// Cuts of a patch with its ends, 0 and 1. Throws std::invalid_argument where a piece between two of
// them is so narrow that it could have no edges of its own.
inline std::vector<double> with_ends(const std::vector<double>& cuts) {
  std::vector<double> lines{0.0};
  lines.insert(lines.end(), cuts.begin(), cuts.end());
  lines.push_back(1.0);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i + 1] - lines[i] > 2.0 * kSameBreak) continue;
    throw std::invalid_argument(
        "A piece of a patch would be narrower than 2e-12 of it: choose a smaller grading, or do "
        "not "
        "divide the patches.");
  }
  return lines;
}

}  // namespace hull::conversion

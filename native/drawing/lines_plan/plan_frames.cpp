// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/plan_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hull::drawing {

std::string frame_name(double x, const PlanFrames& frames) {
  for (std::size_t i = 0; i + 1 < frames.positions.size(); ++i) {
    const double from = frames.positions[i], to = frames.positions[i + 1];
    const double part = (x - from) / (to - from);
    // Falling frames do as well: both differences change their sign.
    if (part < -1e-3 || part > 1.0 + 1e-3) continue;
    if (part < 1e-3) return frames.names[i];
    if (part > 1.0 - 1e-3) return frames.names[i + 1];
    char text[64];
    std::snprintf(text, sizeof text, "%.4g", frames.first + static_cast<double>(i) + part);
    return text;
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.3f", x);
  throw std::invalid_argument("The station at " + std::string(text) +
                              " m is beyond the frames by which it is to be named");
}

void check_frames(const PlanFrames& frames) {
  const std::vector<double>& x = frames.positions;
  // There must be no pair of one of the two kinds. Not a number is both.
  const auto rises_not = [](double a, double b) { return !(b > a); };
  const auto falls_not = [](double a, double b) { return !(b < a); };
  if (x.size() >= 2 && frames.names.size() == x.size() && std::isfinite(x.front()) &&
      std::isfinite(x.back()) &&
      (std::adjacent_find(x.begin(), x.end(), rises_not) == x.end() ||
       std::adjacent_find(x.begin(), x.end(), falls_not) == x.end())) {
    return;
  }
  throw std::invalid_argument("Frames are two or more, with a name each, and follow one another");
}

}  // namespace hull::drawing

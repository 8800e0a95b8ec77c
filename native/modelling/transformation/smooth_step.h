// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace hull::modelling {

// 0 below 0, 1 above 1; in between the polynomial of fifth degree by which slope and curvature
// vanish at both.
inline double smooth_step(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

// Its slope in the middle.
inline constexpr double kSteepestStep = 1.875;

}  // namespace hull::modelling

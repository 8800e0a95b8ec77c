// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace hull::resistance {

// How fine the waves are that a hull's sources are summed for: functions exp(i k x - K d) of the
// distance x ahead and the depth d, K = k²/ν with the wave number ν = g/U² of waves that run as
// fast as the ship. All in 1/m.
struct WaveScales {
  double slowest;  // ν of the lowest speed
  double along;    // the largest k …
  double decay;    // … and K

  // Beyond this many e-foldings a wave does not reach: exp(-25) is 1.4e-11.
  static constexpr double kReach = 25.0;

  // The largest k whose waves reach a depth.
  double along_at(double depth) const {
    return depth > 0.0 ? std::min(along, std::sqrt(kReach * slowest / depth)) : along;
  }
};

}  // namespace hull::resistance

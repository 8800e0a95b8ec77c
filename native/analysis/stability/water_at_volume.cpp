// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/water_at_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hull::analysis {

double greatest_volume(const HullBody& body, const Vector3d& up) {
  const HeightRange range = height_range(body, up);
  // A little higher: in water that touches the top, flat decks would be cut along themselves.
  const double above = range.high + 0.01 * (range.high - range.low);
  return body.immersion({up, above}).volume;
}

double offset_of_volume(const HullBody& body, const Vector3d& up, double volume,
                        double whole_volume, double tolerance, int& evaluations) {
  HeightRange bracket = height_range(body, up);
  // Where a box would float.
  double c = bracket.low + (bracket.high - bracket.low) * volume / whole_volume;
  constexpr int kMost = 100;
  for (int i = 0; i < kMost; ++i) {
    const Immersion at = body.immersion({up, c});
    ++evaluations;
    const double surplus = at.volume - volume;
    if (std::abs(surplus) <= tolerance * std::min(volume, whole_volume - volume)) break;
    (surplus > 0.0 ? bracket.high : bracket.low) = c;
    // Newton's step, as dV/dc is the waterplane's area; halving where it leaves the bracket, as by
    // no area at all: infinities and what is not a number are not inside.
    const double newton = c - surplus / at.waterplane_area;
    const bool inside = newton > bracket.low && newton < bracket.high;
    c = inside ? newton : 0.5 * (bracket.low + bracket.high);
  }
  return c;
}

}  // namespace hull::analysis

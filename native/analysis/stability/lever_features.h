// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analysis/stability/heeling_path.h"

namespace hull::analysis {

// What to read from a curve of righting levers between the first and the last of some heels, rad.
// They say how closely to look: between two neighbours the curve is taken to have no feature that
// shows at neither of them. Found on the exact curve, to 1e-12 rad or rounding.
//
// REQUIRES of `heels`: at least one, ascending. As HeelingPath::at() they throw
// std::invalid_argument where the ship stands on end.

// The heels of a list that are between two heels, and these themselves; ascending, each once.
std::vector<double> heels_between(const std::vector<double>& heels, double from, double to);

struct GreatestLever {
  double heel = 0.0, lever = 0.0;  // rad, m
  bool at_end = false;  // the curve is still rising where it ends, or falls from where it
                        // begins
};
GreatestLever greatest_lever(HeelingPath& path, const std::vector<double>& heels);

// The first heel at which the righting lever, having been positive, vanishes.
std::optional<double> vanishing_heel(HeelingPath& path, const std::vector<double>& heels);

// The first heel at which the righting lever, having been below a heeling lever (m), comes up to
// it; and at which, having been above, it falls to it.
std::optional<double> lever_rises_to(HeelingPath& path, const std::vector<double>& heels,
                                     double heeling_lever);
std::optional<double> lever_falls_to(HeelingPath& path, const std::vector<double>& heels,
                                     double heeling_lever);

// The first heel at which something comes under water, given as the height of its lowest point
// along the upward direction; the first of the heels if it is there already.
using LowestPoint = std::function<double(const Vector3d& up)>;
std::optional<double> immersion_heel(HeelingPath& path, const std::vector<double>& heels,
                                     const LowestPoint& lowest);

}  // namespace hull::analysis

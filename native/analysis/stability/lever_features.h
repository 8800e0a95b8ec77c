// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "analysis/stability/heeling_path.h"

namespace hull::analysis {

// What to read from a curve of righting levers between two heels, from < to. The states the path
// has solved there say where to look: a feature between two of them that shows at neither end is
// not seen. Found on the exact curve, to 1e-12 rad or rounding.

struct GreatestLever {
  double heel = 0.0, lever = 0.0;  // rad, m
  bool at_end = false;  // the curve is still rising where it ends, or falls from where it
                        // begins
};
GreatestLever greatest_lever(const HeelingPath& path, double from, double to);

// The first heel at which the righting lever, having been positive, vanishes.
std::optional<double> vanishing_heel(const HeelingPath& path, double from, double to);

// The first heel at which something comes under water, given as the height of its lowest point
// along the upward direction; `from` if it is there already.
using LowestPoint = std::function<double(const Vector3d& up)>;
std::optional<double> immersion_heel(const HeelingPath& path, const LowestPoint& lowest,
                                     double from, double to);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/stability/heeling_path.h"
#include "surface/progress.h"

namespace hull::analysis {

struct CrossCurveOptions {
  TrimMode trim_mode = TrimMode::kFree;
  double trim = 0.0;  // rad: held; of the upright position where trim is free: must be zero there
  // Height of the centre of gravity assumed for the trim, m. Levers are counted from the base line
  // whatever it is; it matters only to the trim, and little.
  double assumed_kg = 0.0;
  surface::Progress progress = {};
};

// Righting levers KN about the base line, for one displacement.
struct CrossCurve {
  double volume = 0.0;         // m³
  double lcg = 0.0;            // m: that of the buoyancy upright, at which the trim is balanced
  std::vector<double> levers;  // KN, m: one for each heel
  std::vector<double> trims;   // rad
  int evaluations = 0;         // immersions computed
};

// KN = (B - K)·starboard, K = (lcg, 0, 0). The righting lever of a ship with her centre of gravity
// at the height KG, off the centre plane by y to port, is GZ = KN - KG sin(heel) + y cos(heel).
//
// Throws std::invalid_argument unless volumes are positive and below that of the body, and heels
// are finite.
std::vector<CrossCurve> cross_curves(const HullBody& body, const std::vector<double>& volumes,
                                     const std::vector<double>& heels,
                                     const CrossCurveOptions& options = {});

}  // namespace hull::analysis

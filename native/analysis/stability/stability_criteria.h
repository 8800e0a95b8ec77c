// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/stability/criterion.h"
#include "analysis/stability/righting_levers.h"

namespace hull::analysis {

struct StabilityOptions {
  TrimMode trim_mode = TrimMode::kFree;
  double trim = 0.0;  // rad: held, or the first guess
  StabilityEdges edges;
};

struct StabilityReport {
  std::vector<Criterion> criteria;
  bool passes = false;                      // all of them
  std::optional<double> downflooding_heel;  // rad, if below 90°
  std::optional<double> deck_edge_heel;     // rad, if below 90°; 0 if it is under water upright
  bool can_flood = false, has_deck_edge = false;  // whether there was anything to look for
  int evaluations = 0;                            // immersions computed
};

// The general intact stability criteria of the International Code on Intact Stability, 2008 (IMO
// resolution MSC.267(85)), Part A, 2.2, for heels to starboard; ships that are not symmetric, or
// not so loaded, are to be asked for both sides, the second time mirrored. The severe wind and
// rolling criterion, 2.3, is that of weather_criterion.h.
//
// Areas are integrals from heel 0, so that levers below zero reduce them; to 1e-8 m·rad. The curve
// ends where the ship floods, and is looked at up to 90°. Where she floods before 30° what the
// code asks of the curve up to or beyond 30° is not met. Without downflooding points no heel is
// taken to flood her, and the notes say so.
//
// Throws std::invalid_argument as righting_levers() does for the load and the deck edge.
StabilityReport stability_criteria(const HullBody& body, const LoadCase& load,
                                   const StabilityOptions& options = {});

}  // namespace hull::analysis

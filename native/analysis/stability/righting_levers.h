// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/stability/heeling_path.h"
#include "analysis/stability/load_case.h"
#include "analysis/stability/stability_edges.h"

namespace hull::analysis {

struct RightingLeverOptions {
  TrimMode trim_mode = TrimMode::kFree;
  double trim = 0.0;  // rad: held, or the first guess
  StabilityEdges edges;
  std::vector<std::array<double, 2>> area_intervals;  // rad
  double area_tolerance = 1e-9;                       // m·rad
};

// A curve of righting levers; heel positive to starboard, levers positive where they right such a
// heel. What is found on it lies between 0 and the greatest heel asked for, mostly between those
// asked for (lever_features.h).
struct RightingLevers {
  std::vector<HeeledState> states;  // at the heels asked for, in that order
  double gm = 0.0;                  // m: dGZ/dheel upright, with what the trim does to it
  std::optional<GreatestLever> greatest;
  std::optional<double> vanishing_heel;
  std::optional<double> deck_edge_heel;     // where it comes under water; 0 if it is so upright
  std::optional<double> downflooding_heel;  // where the first point or opening comes under water
  bool has_deck_edge = false, can_flood = false;  // whether these two could be looked for
  std::vector<double> areas;                      // m·rad, one for each interval
  int curve_evaluations = 0;                      // immersions computed for `states`
  int evaluations = 0;                            // in all
};

// Levers are those of the body with all openings closed, beyond the heel that floods her too.
// Throws std::invalid_argument for a load that is none or sinks the body, heels that are not finite
// or none, a trim of 90° or more, and where the ship stands on end.
RightingLevers righting_levers(const HullBody& body, const LoadCase& load,
                               const std::vector<double>& heels,
                               const RightingLeverOptions& options = {});

// The path for a load: checks as above.
HeelingPath heeling_path(const HullBody& body, const LoadCase& load, TrimMode mode, double trim);

}  // namespace hull::analysis

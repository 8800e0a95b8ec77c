// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/stability/heeling_path.h"
#include "analysis/stability/lever_features.h"
#include "analysis/stability/load_case.h"

namespace hull::analysis {

// What floods a ship, and where her deck is.
struct StabilityEdges {
  // Lower corners of openings that can't be closed weathertight, m; of both sides.
  std::vector<Vector3d> downflooding_points;
  // Control points of the creases or borders that are the deck's edge; without any, the surface's
  // borders along the ship.
  std::vector<int> deck_edge_vertices;
};

struct RightingLeverOptions {
  TrimMode trim_mode = TrimMode::kFree;
  double trim = 0.0;  // rad: held, or the first guess
  StabilityEdges edges;
  std::vector<std::array<double, 2>> area_intervals;  // rad
  double area_tolerance = 1e-9;                       // m·rad
};

// A curve of righting levers; heel positive to starboard, levers positive where they right such a
// heel. Particulars refer to heels from 0 to the greatest asked for, and are looked for between
// those asked for (lever_features.h).
struct RightingLevers {
  std::vector<HeeledState> states;  // at the heels asked for, in that order
  double gm = 0.0;                  // m: dGZ/dheel upright, with what the trim does to it
  std::optional<GreatestLever> greatest;
  std::optional<double> vanishing_heel;
  std::optional<double> deck_edge_heel;  // where it comes under water; 0 if it is so upright
  std::optional<double> flooding_heel;   // where the first point or opening comes under water
  bool has_deck_edge = false, has_openings = false;  // whether these two could be looked for
  std::vector<double> areas;                         // m·rad, one for each interval
  int curve_evaluations = 0;                         // immersions computed for `states`
  int evaluations = 0;                               // in all
};

// Levers are those of the body with all openings closed, beyond the heel that floods her too.
// Throws std::invalid_argument for a load that is none or sinks the body, heels that are not finite
// or none, a trim of 90° or more, and where the ship stands on end.
RightingLevers righting_levers(const HullBody& body, const LoadCase& load,
                               const std::vector<double>& heels,
                               const RightingLeverOptions& options = {});

// The path for a load: checks as above.
HeelingPath heeling_path(const HullBody& body, const LoadCase& load, TrimMode mode, double trim);

// The first heel, from 0 to `to`, that floods the ship through one of the points, or through an
// opening of `body` that is not closed.
std::optional<double> flooding_heel(const HeelingPath& path, const HullBody& body,
                                    const StabilityEdges& edges, double to);
// Whether there is anything of that kind.
bool can_flood(const HullBody& body, const StabilityEdges& edges);

}  // namespace hull::analysis

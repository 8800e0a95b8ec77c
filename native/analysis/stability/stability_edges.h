// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/stability/deck_edge.h"
#include "analysis/stability/lever_features.h"

namespace hull::analysis {

// What floods a ship, and where her deck is.
struct StabilityEdges {
  // Lower corners of openings that can't be closed weathertight, m; of both sides.
  std::vector<Vector3d> downflooding_points;
  // Control points of the creases or borders that are the deck's edge; without any, the surface's
  // borders along the ship.
  std::vector<int> deck_edge_vertices;
};

// Throws std::invalid_argument as DeckEdge does.
DeckEdge deck_edge_of(const HullBody& body, const StabilityEdges& edges);

// The first heel among and between `heels` (lever_features.h) at which the deck edge comes under
// water; none where there is no edge.
std::optional<double> deck_edge_heel(HeelingPath& path, const DeckEdge& edge,
                                     const std::vector<double>& heels);

// Whether there is anything through which the ship could flood: a point, or an opening of `body`
// that is not closed.
bool can_flood(const HullBody& body, const StabilityEdges& edges);

// The first heel among and between `heels` that floods her through it: the downflooding angle.
std::optional<double> downflooding_heel(HeelingPath& path, const HullBody& body,
                                        const StabilityEdges& edges,
                                        const std::vector<double>& heels);

}  // namespace hull::analysis

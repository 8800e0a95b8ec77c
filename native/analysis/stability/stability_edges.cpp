// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_edges.h"

#include <algorithm>
#include <cmath>

namespace hull::analysis {

DeckEdge deck_edge_of(const HullBody& body, const StabilityEdges& edges) {
  return edges.deck_edge_vertices.empty() ? DeckEdge(body)
                                          : DeckEdge(body, edges.deck_edge_vertices);
}

std::optional<double> deck_edge_heel(HeelingPath& path, const DeckEdge& edge,
                                     const std::vector<double>& heels) {
  if (edge.empty()) return std::nullopt;
  return immersion_heel(path, heels, [&](const Vector3d& up) { return edge.lowest(up); });
}

bool can_flood(const HullBody& body, const StabilityEdges& edges) {
  return !edges.downflooding_points.empty() ||
         std::isfinite(body.lowest_opening(Vector3d::UnitZ()));
}

std::optional<double> downflooding_heel(HeelingPath& path, const HullBody& body,
                                        const StabilityEdges& edges,
                                        const std::vector<double>& heels) {
  // The path's body is weathertight; `body` is the one that may have open borders.
  const auto lowest = [&](const Vector3d& up) {
    double least = body.lowest_opening(up);
    for (const Vector3d& p : edges.downflooding_points) least = std::min(least, up.dot(p));
    return least;
  };
  return immersion_heel(path, heels, lowest);
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/stability/heeling_path.h"
#include "analysis/stability/load_case.h"
#include "analysis/stability/stability_edges.h"
#include "bindings/arrays.h"

// The arguments that the functions about the stability of a load have in common.
namespace hull::bindings {

inline analysis::TrimMode mode_of(bool free_trim) {
  return free_trim ? analysis::TrimMode::kFree : analysis::TrimMode::kFixed;
}

inline analysis::LoadCase load_from(double mass_t, const DoubleArray& centre_of_gravity,
                                    double water_density) {
  return {mass_t, point_from(centre_of_gravity, "centre_of_gravity"), water_density};
}

inline analysis::StabilityEdges edges_from(const std::optional<DoubleArray>& points,
                                           const py::object& deck_edge) {
  analysis::StabilityEdges edges;
  if (points) edges.downflooding_points = points_from(*points, "downflooding_points");
  if (!deck_edge.is_none()) edges.deck_edge_vertices = integers_from(deck_edge, "deck_edge");
  return edges;
}

}  // namespace hull::bindings

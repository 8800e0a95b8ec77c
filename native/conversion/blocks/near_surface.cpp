// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/near_surface.h"

#include <algorithm>
#include <optional>

#include "conversion/blocks/block_places.h"

namespace hull::conversion {
namespace {

// Around a point of high valence the nearest point may be some cells further on.
constexpr int kMostCells = 8;

// Where on side k of its cell a place is, counted along the side; none if it is not on it.
std::optional<double> on_side(const CellPoint& place, int k) {
  switch (k) {
    case 0:
      return place.v == 0.0 ? std::optional(place.u) : std::nullopt;
    case 1:
      return place.u == 1.0 ? std::optional(place.v) : std::nullopt;
    case 2:
      return place.v == 1.0 ? std::optional(1.0 - place.u) : std::nullopt;
    default:
      return place.u == 0.0 ? std::optional(1.0 - place.v) : std::nullopt;
  }
}

double to_corner(const CellPoint& place) {
  return std::max(std::min(place.u, 1.0 - place.u), std::min(place.v, 1.0 - place.v));
}

}  // namespace

NearPoint near_surface(const RingedSurface& surface, const Vector3d& point, const CellPoint& start,
                       double enough) {
  const mesh::Topology& cells = surface.cells();
  // No search can begin at an irregular corner, which has no derivatives: as far from it as here.
  const double inset = 0.5 * to_corner(start);
  NearPoint best = near_point(surface, point, start, enough);
  for (int i = 0; i < kMostCells && best.distance > enough; ++i) {
    const CellPoint from = best.place;
    for (int k = 0; k < 4; ++k) {
      const std::optional<double> along = on_side(from, k);
      const int beyond = along ? cells.twin(4 * from.cell + k) : -1;
      if (beyond < 0) continue;
      const double at = std::clamp(1.0 - *along, inset, 1.0 - inset);
      const NearPoint found =
          near_point(surface, point, place_beside_half_edge(beyond, at, 0.0), enough);
      if (found.distance < best.distance) best = found;
    }
    // A foot within its cell, or on a side beyond which nothing is nearer.
    if (best.place.cell == from.cell) break;
  }
  return best;
}

}  // namespace hull::conversion

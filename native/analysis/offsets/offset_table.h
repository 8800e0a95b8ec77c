// SPDX-License-Identifier: GPL-3.0-or-later
// The table of offsets: a hull in heights and half-breadths at its stations, as it is lofted.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "surface/creases/crease_chains.h"
#include "surface/limit_surface.h"

namespace hull::analysis {

// One length of the table, m; not a number where the station has no such point.
struct Offset {
  double value = std::numeric_limits<double>::quiet_NaN();
  bool on_knuckle = false;
};

// A crease or border that runs along the hull: its point at each station, NaN where it has none.
struct FeatureOffsets {
  std::string name;  // "Deck edge", "Knuckle 1"
  surface::CreaseKind kind;
  std::vector<double> half_breadths, heights;
};

struct OffsetTable {
  std::vector<double> stations, waterlines, buttocks;  // x, z and y >= 0, m, as given
  std::vector<Offset> half_breadths;                   // a row of waterlines for each station
  std::vector<Offset> heights;                         // a row of buttocks for each station
  std::vector<FeatureOffsets> features;                // from below upwards

  const Offset& half_breadth(std::size_t station, std::size_t waterline) const {
    return half_breadths[station * waterlines.size() + waterline];
  }
  const Offset& height(std::size_t station, std::size_t buttock) const {
    return heights[station * buttocks.size() + buttock];
  }
};

// Of the port half, y >= 0, which is the surface where `mirrored`, else a part of it.
//
// A half-breadth is the largest of the station at the waterline's height, a height the lowest of
// the station at the buttock: where the hull is flat there, the flat part's outer or lower edge.
// The buttock 0 gives the height of the keel, stem and stern. A station in the plane of a transom
// or flat end is that part's edge. Values are of the surface to 1e-7 of the mesh's size where the
// station crosses the waterline or buttock at an angle, more where it is nearly along it.
//
// Features are crease_curves() outside the centre plane, joined where one goes on straight in
// another; their values are exact. One that meets a station more than once counts furthest out.
// A border is named "Deck edge" if it is the only one, else "Edge 1", ...; creases "Knuckle 1", ...
//
// Throws std::invalid_argument for a position that is not finite, a negative buttock, more than
// kMostOffsetPositions of a kind, and a surface without that half (missing_port_side()).
OffsetTable offset_table(const surface::LimitSurface& surface, const std::vector<double>& stations,
                         const std::vector<double>& waterlines, const std::vector<double>& buttocks,
                         bool mirrored = true);

inline constexpr std::size_t kMostOffsetPositions = 1000;

}  // namespace hull::analysis

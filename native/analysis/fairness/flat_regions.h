// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// A closed curve around a flat region, by the Bézier points of its cubics, in order; the region is
// on its left, seen from outside.
struct FlatBorder {
  std::vector<std::array<Vector3d, 4>> cubics;  // m
};

// Cells next to one another whose control points lie in one plane.
struct FlatRegion {
  Plane plane;             // the normal points to the side of the surface's
  std::vector<int> cells;  // rising
  double area;             // m²
  std::vector<FlatBorder> borders;
};

// Flat of bottom, flat of side, flat transoms: regions of cells whose control points are no further
// than `tolerance` (m) from a plane, and so is the surface. Largest area first; those below
// `smallest_area` (m²) are left out. With a plane given, only regions in that.
//
// Borders are the sides of cells, exactly: a cubic is a whole side, or a half of it and so on
// towards an irregular knot, where the last 2^-10 is a cubic with the right ends only. Regions go
// on across creases. Throws std::invalid_argument for a tolerance that is not above zero.
std::vector<FlatRegion> flat_regions(const surface::LimitSurface& surface,
                                     const std::optional<Plane>& plane, double tolerance,
                                     double smallest_area = 0.0);

}  // namespace hull::analysis

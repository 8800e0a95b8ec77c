// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "morphing/parametrisation/disc_map.h"

namespace hull::morphing {

// A border point of one of two mapped discs, or of both.
struct CommonBorderPoint {
  std::array<int, 2> points;      // of each disc, or -1
  std::array<int, 2> half_edges;  // of each disc, along the border: what comes next lies on it
};

// The borders of two discs that are mapped onto one polygon, as one (Kang & Lee 2012, figure 8).
struct CommonBorder {
  std::vector<CommonBorderPoint> points;  // in order from the first corner
  // Of all points of each disc, those of places() but for border points that both have.
  std::array<std::vector<Vector2d>, 2> places;
};

// Border points whose lengths along their side differ by less than 1e-9 of it are one, and get the
// place of the one that comes first.
//
// In the plane the border is the chain of these places, which are on the polygon's sides to
// rounding: the area that both discs cover exactly, a triangle at the border being that between its
// inner edges and the chain.
//
// Throws std::invalid_argument unless both are mapped onto the same polygon, and for a triangle
// that has no area beside this chain.
CommonBorder common_border(const DiscMap& first, const DiscMap& second);

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "network/crossings/curve_tree.h"

namespace hull::network {

// Parts of two segments within a distance of one another: shares of either from 0 to 1, and those
// where they are nearest.
struct SegmentZone {
  double first_low, first_high, first_nearest;
  double second_low, second_high, second_nearest;
};

// None where they are further apart.
std::optional<SegmentZone> near_segments(const Vector3d& first_start, const Vector3d& first_end,
                                         const Vector3d& second_start, const Vector3d& second_end,
                                         double reach);

// Intervals of two curves' parameters in which they are near one another, by straight parts.
struct NearZone {
  double first_low, first_high, first_nearest;
  double second_low, second_high, second_nearest;
};

std::vector<NearZone> near_zones(CurveTree& first, CurveTree& second, double reach);

// Zones that hang together, over both curves.
std::vector<std::vector<NearZone>> coherent_zones(const std::vector<NearZone>& zones);

}  // namespace hull::network

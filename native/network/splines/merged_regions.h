// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/patches/region_sides.h"

namespace hull::network {

// A region between boundaries, or several that only reference curves part.
struct MergedRegion {
  std::vector<int> regions;       // of the network
  std::vector<RegionSide> sides;  // counterclockwise seen from outside
  std::vector<int> references;    // edges within
};

// Regions joined over edges that are references. Where that does not make a region within four
// sides, each along one curve, they stay apart. Knuckles of the surface are no references.
std::vector<MergedRegion> merged_regions(const NetworkFrame& frame,
                                         const std::vector<std::vector<RegionSide>>& regions,
                                         const std::vector<bool>& is_reference);

}  // namespace hull::network

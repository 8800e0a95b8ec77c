// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/patch_set.h"
#include "network/splines/region_quads.h"

namespace hull::network {

// What a region consists of, and where.
struct PlacedQuads {
  const RegionQuads* quads;
  std::vector<std::array<QuadBorder, 4>> borders;  // of its patches
};

struct JoinedQuads {
  conversion::PatchSet set;
  std::vector<int> edges;  // of edges of the set the network's; -1: within a region
};

// The patches of regions as one set, in their order. Edges of the network are edges of the set, cut
// where patches of either side of them end.
JoinedQuads joined_quads(const NetworkFrame& frame, const std::vector<PlacedQuads>& regions);

}  // namespace hull::network

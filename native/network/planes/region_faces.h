// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/planes/node_order.h"

namespace hull::network {

// An edge in the sense in which a region has it to its left.
struct RegionEdge {
  int edge;
  bool is_along;
};

// The regions of a network, each by the edges around it, counterclockwise seen from outside.
struct RegionFaces {
  Regions topology;
  std::vector<std::vector<RegionEdge>> loops;  // of regions
  std::vector<RegionEdge> border;              // around what is beyond
  std::vector<int> region_of_side;             // 2 edge + (0 along, 1 against): -1 beyond

  // Whether one side of an edge is beyond.
  bool is_border(int edge) const {
    const auto at = 2 * static_cast<std::size_t>(edge);
    return region_of_side[at] < 0 || region_of_side[at + 1] < 0;
  }
};

// Of the faces between edges that one is beyond the network's border around which the way turns
// least: by Gauss and Bonnet it turns by 2π less what the surface within is curved, and around
// what is beyond by that less 2π.
//
// Throws NetworkFault as regions_between() does.
RegionFaces region_faces(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                         const NodeOrder& order);

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "morphing/overlay/common_border.h"
#include "morphing/overlay/edge_walk.h"

namespace hull::morphing {

// The way of an inner edge of one disc through the other one.
struct EdgeTrace {
  int half_edge;     // of its own disc, in the direction of the walk
  int begin, count;  // of EdgeTraces::stretches
};

// One disc in the other.
struct EdgeTraces {
  std::vector<Location> locations;  // of each point
  std::vector<EdgeTrace> paths;     // of each inner edge
  std::vector<Stretch> stretches;
};

// Of disc 0 or 1 of `maps` in the other one.
EdgeTraces trace_edges(const std::array<const DiscMap*, 2>& maps, const CommonBorder& border,
                       int disc);

}  // namespace hull::morphing

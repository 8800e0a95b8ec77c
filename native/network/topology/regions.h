// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <vector>

#include "network/topology/shells.h"

namespace hull::network {

// A part of a curve between two nodes with none between, by the caller's numbers from 0.
struct NetworkEdge {
  int from, to;
  int curve;
};

// The end of an edge at a node.
struct EdgeEnd {
  int edge;
  bool is_start;
};

// Edges that cannot be drawn on one closed surface without crossing one another.
class NetworkFault : public std::invalid_argument {
 public:
  NetworkFault(const std::string& what, std::vector<int> its_edges)
      : std::invalid_argument(what), edges(std::move(its_edges)) {}
  std::vector<int> edges;
};

// The regions between the edges of a network, as faces of one shell without holes; beyond a
// network's border is a region, too.
struct Regions {
  Shells shells;
  std::vector<int> vertex_of_node;
  std::vector<int> half_of_edge;  // the one from the edge's start to its end
};

// `around`: the ends at each node, counterclockwise as seen from outside the hull. Edges come one
// after the other by the operators MEV and MEF.
//
// Throws NetworkFault for edges that are not connected with the first one (those are named), and
// for one that leaves a face where it does not come in again: then the orders around its nodes
// contradict one another. std::invalid_argument for numbers that are not there, ends that do not
// stand once each at their node, and networks without edges.
Regions regions_between(int node_count, const std::vector<NetworkEdge>& edges,
                        const std::vector<std::vector<EdgeEnd>>& around);

}  // namespace hull::network

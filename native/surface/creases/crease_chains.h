// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/topology.h"

namespace hull::surface {

enum class CreaseKind { kCrease, kBorder };

// A control edge as a step of a chain: a half-edge of it, run along or against.
struct ChainStep {
  int half_edge;
  bool forward;

  int from(const mesh::Topology& t) const {
    return t.origin(forward ? half_edge : t.next(half_edge));
  }
  int to(const mesh::Topology& t) const { return reversed().from(t); }
  ChainStep reversed() const { return {half_edge, !forward}; }
  // The half-edges that run along the step, left of it, and against it; -1 where no face is.
  int left(const mesh::Topology& t) const { return forward ? half_edge : t.twin(half_edge); }
  int right(const mesh::Topology& t) const { return reversed().left(t); }
};

// Crease or border edges that follow one another through vertices of the crease rule. A chain ends
// at all others: corners, cone tips, darts. Borders and inner creases never share a vertex of the
// crease rule, so that a chain is all of one kind.
struct CreaseChain {
  CreaseKind kind;
  bool closed;  // has no end
  std::vector<ChainStep> steps;
  std::vector<int> vertices;  // in order; a closed chain's first is not repeated
};

// All chains, each crease and border edge in one of them. One with a dart at one end starts there.
std::vector<CreaseChain> crease_chains(const mesh::Topology& topology);

}  // namespace hull::surface

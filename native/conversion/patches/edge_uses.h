// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "conversion/patches/patch_set.h"
#include "mesh/groups.h"

namespace hull::conversion {

// A part of a patch's side, by place.
struct EdgeUse {
  int patch = -1, side = -1, part = -1;

  bool operator==(const EdgeUse&) const = default;
};

// Where the edges of a set are. REQUIRES: set.check() does not throw, and the set outlives this.
class EdgeUses {
 public:
  explicit EdgeUses(const PatchSet& set);

  const std::array<EdgeUse, 2>& of(int edge) const { return uses_[edge]; }
  // Edges with one patch, a border of the set. Unused numbers are none.
  bool is_border(int edge) const { return uses_[edge][0].patch >= 0 && uses_[edge][1].patch < 0; }
  // Edges of no length: all their control points lie within kNoLength of the size.
  bool is_collapsed(int edge) const { return collapsed_[edge]; }
  // The number that stands for a vertex and those that edges of no length join it to.
  int vertex(int number) const { return vertices_[number]; }

  const SideEdge& part(const EdgeUse& use) const {
    return set_.sides[use.patch][use.side][use.part];
  }
  BSplineCurve curve(const EdgeUse& use) const {
    return set_.curve(use.patch, use.side, part(use));
  }
  // The use that follows counter-clockwise around the patch.
  EdgeUse next(EdgeUse use) const;

 private:
  const PatchSet& set_;
  std::vector<std::array<EdgeUse, 2>> uses_;
  std::vector<bool> collapsed_;
  std::vector<int> vertices_;
};

// The borders of a set: each a closed round of uses, in the direction of their patches, without
// those of no length. Where borders touch in a vertex each goes on along its own patches.
std::vector<std::vector<EdgeUse>> border_loops(const EdgeUses& uses, int edge_count);

}  // namespace hull::conversion

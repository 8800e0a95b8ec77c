// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/edge_uses.h"

#include "mesh/tolerances.h"

namespace hull::conversion {

EdgeUses::EdgeUses(const PatchSet& set)
    : set_(set), uses_(set.edge_count), collapsed_(set.edge_count, false) {
  const double tolerance = kNoLength * set.size();
  mesh::Groups groups(set.vertex_count);
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (int i = 0; i < static_cast<int>(set.sides[p][k].size()); ++i) {
        const SideEdge& side = set.sides[p][k][i];
        uses_[side.edge][uses_[side.edge][0].patch >= 0] = {p, k, i};
        if (set.curve(p, k, side).polygon_length() > tolerance) continue;
        collapsed_[side.edge] = true;
        // Both ends are one vertex, or what meets there would not join.
        groups.join(side.from, side.to);
      }
    }
  }
  for (int v = 0; v < set.vertex_count; ++v) vertices_.push_back(groups.find(v));
}

EdgeUse EdgeUses::next(EdgeUse use) const {
  if (++use.part < static_cast<int>(set_.sides[use.patch][use.side].size())) return use;
  return {use.patch, (use.side + 1) % 4, 0};
}

std::vector<std::vector<EdgeUse>> border_loops(const EdgeUses& uses, int edge_count) {
  std::vector<char> done(edge_count, 0);
  std::vector<std::vector<EdgeUse>> loops;
  for (int edge = 0; edge < edge_count; ++edge) {
    if (!uses.is_border(edge)) continue;
    std::vector<EdgeUse> loop;
    EdgeUse use = uses.of(edge)[0];
    while (!done[uses.part(use).edge]) {
      const int number = uses.part(use).edge;
      done[number] = 1;
      // Walked along like any other, but not told.
      if (!uses.is_collapsed(number)) loop.push_back(use);
      // Around the vertex, from patch to patch, to the next border.
      use = uses.next(use);
      while (!uses.is_border(uses.part(use).edge)) {
        const auto& [one, two] = uses.of(uses.part(use).edge);
        use = uses.next(use == one ? two : one);
      }
    }
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace hull::conversion

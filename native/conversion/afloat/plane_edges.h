// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "analysis/sections/height_net.h"
#include "analysis/sections/section_point.h"
#include "conversion/afloat/patch_pieces.h"

namespace hull::conversion {

// Edges of pieces that lie in a plane: what analysis::PlaneSides are of cells. Each piece says what
// it knows of its own sides; both pieces of an edge are then seen together, by the same rules.
class PlaneEdges {
 public:
  PlaneEdges(const PatchPieces& pieces, const analysis::Plane& plane)
      : pieces_(pieces), plane_(plane) {}

  // A piece that lies in the plane.
  void add_flat(int piece);
  // A piece of which these sides do.
  void add_sides(int piece, const analysis::HeightNet& height);

  // Adds what belongs to the section.
  void add_arcs(double chord_tolerance, analysis::SectionParts& parts) const;

 private:
  enum class State { kNone, kFlat, kAbove, kBelow };

  void claim(const EdgeUse& use, State state);
  void add_edge(int edge, State left, State right, double chord_tolerance,
                analysis::SectionParts& parts) const;

  const PatchPieces& pieces_;
  const analysis::Plane& plane_;
  std::map<int, std::array<State, 2>> states_;  // of edges, on the sides of their uses
};

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

// An edge, against the direction of its curve if reversed.
struct DirectedEdge {
  int edge = -1;
  bool reversed = false;

  DirectedEdge operator-() const { return {edge, !reversed}; }
  bool operator==(const DirectedEdge&) const = default;
};
using EdgePath = std::vector<DirectedEdge>;

// A curve of a closing alone: where two caps meet, or a cap and the centre plane.
struct CapEdge {
  BSplineCurve curve;
  int from = -1, to = -1;
};

// One face that closes a hull: a plane face or a patch. What it bounds lies on the left of its
// edges, seen from outside.
struct Cap {
  enum class Kind { kDeck, kTransom, kCentrePlane, kOpening };
  Kind kind = Kind::kOpening;
  // A patch of degree 1 along u; side 1 is the hull's border, side 3 the far one. None: a plane.
  std::optional<BSplinePatch> patch;
  // Of a patch: its four sides, of which a side of no length has none. Of a plane face: its outer
  // border, then its holes.
  std::vector<EdgePath> loops;
  // Of a plane face.
  Vector3d origin = Vector3d::Zero(), normal = Vector3d::UnitZ();
};

// What closes a set: its caps, and their edges and vertices beyond the set's own, whose numbers
// follow those of the set.
struct Closing {
  std::vector<CapEdge> edges;
  std::vector<Vector3d> vertices;
  std::vector<Cap> caps;
};

// The caps that make a closed shell of a hull; none where it has no border.
//
// A half hull is a set with borders in the centre plane y = 0, wholly on one side of it. Its other
// borders, from where they leave the centre plane to where they meet it again, are closed by
// straight athwartships lines to it: by one plane face wherever these lines make a plane (level
// decks, flat transoms), and by a patch (x, y, z) -> (x, 0, z) for every other edge, which has the
// edge's own knots. What is then open in the centre plane is closed by plane faces, with holes
// where there are some.
//
// Of all other sets, and of borders of a half hull that do not meet the centre plane, a border in
// one plane is closed by one plane face. One that is symmetric, port and starboard, is closed by
// athwartships lines between its sides in the same way. An edge that crosses the plane of symmetry,
// as around a bow, is divided there into two edges of the set.
//
// Throws std::invalid_argument, saying where and what to do about it, at a border that is neither.
// REQUIRES: set.check() does not throw; borders in the centre plane of a half hull lie in it as
// with_seam_in_plane() puts them.
Closing closing_of(PatchSet& set);

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "conversion/blocks/block_layout.h"
#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {

// A part of a patch's side: an edge that the patch shares with at most one other.
struct SideEdge {
  int edge = -1;                  // its number
  int from = -1, to = -1;         // vertex numbers of its ends, in the side's direction
  double begin = 0.0, end = 1.0;  // of the side's parameter, which is 0 where the side begins

  bool operator==(const SideEdge&) const = default;
};

// The edges of a side one after another, from 0 to 1. More than one where neighbours meet within
// the side, or a border turns into another one.
using PatchSide = std::vector<SideEdge>;

// Of the set's size: edges of two patches lie no further apart.
inline constexpr double kLargestGap = 1e-13;

// What patches were made of.
struct PatchSource {
  // The control points of the surface that the blocks are of; null where there is none.
  std::shared_ptr<const std::vector<Vector3d>> points;
  // Which of them keep its centre line from the centre plane although they were probably meant to
  // be on it, and which make gaps of it (mesh/centre_plane.h): the mirror image does not join
  // there.
  std::vector<int> near_centre_line, gaps;
};

// Patches that join into a surface, and how: edges with the same number are one curve, vertices
// with the same number one point. Corner k of a patch is where its side k begins.
struct PatchSet {
  std::vector<BSplinePatch> patches;
  std::vector<std::array<int, 4>> corners;      // per patch, vertex numbers 0 ... vertex_count - 1
  std::vector<std::array<PatchSide, 4>> sides;  // per patch, of edges 0 ... edge_count - 1
  // Per patch the cells that it stands for, whose (u, v) are the patch's; one without sides where
  // it stands for none, as caps and mirror images do. Empty where nothing is known of any.
  std::vector<Block> blocks;
  // Of each cell of the surface the face of the control mesh that it is of, so that messages can
  // name it. Empty where nothing is known of any.
  std::vector<int> cell_faces;
  int vertex_count = 0;
  int edge_count = 0;
  PatchSource source;

  // Diagonal of the box around all control points, m; 0 without any. What tolerances refer to.
  double size() const;

  // The curve of a part of a patch's side, in the side's direction.
  BSplineCurve curve(int patch, int side, const SideEdge& part) const {
    return patches[patch].side_curve(side).part(part.begin, part.end);
  }

  // The largest distance of the two curves of an edge at equal parameters, m.
  double largest_gap() const;

  // Throws std::invalid_argument naming the cell if a patch is malformed, a number is out of range,
  // the parts of a side do not follow one another, an edge has more than two patches or two that
  // run the same way along it, the two curves of an edge differ by more than kLargestGap of the
  // size, or the corners of one vertex do at all; and if there are blocks, but not one per patch.
  void check() const;
};

// A side that is one edge between two corners of its patch.
inline PatchSide whole_side(int edge, int from, int to) { return {{edge, from, to, 0.0, 1.0}}; }

}  // namespace hull::conversion

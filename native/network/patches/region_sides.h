// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "network/patches/ribboned_side.h"
#include "network/planes/edge_normals.h"

namespace hull::network {

// What the sides of regions are made of; all by the numbers of edges and nodes.
struct NetworkFrame {
  JoinedCurves joined;
  std::vector<EdgeShape> shapes;
  NodeOrder order;
  RegionFaces faces;
  EdgeNormals normals;
};

// A side of a region: its edges, one after the other.
using RegionSide = std::vector<RegionEdge>;

// The sides of a region, between its corners: nodes where it turns by more than 15° (Koelman 1999,
// 5.4.1.2), or by a knuckle of a curve as much. Where that leaves fewer than two sides, all nodes
// are corners at which two curves meet, or two pieces of a curve.
std::vector<RegionSide> region_sides(const NetworkFrame& frame,
                                     const std::vector<RegionEdge>& loop);

// Sides cut where one curve, or piece of a curve, goes on in another one.
std::vector<RegionSide> sides_of_one_curve(const NetworkFrame& frame,
                                           const std::vector<RegionSide>& sides);

// With sides that are shorter than a fiftieth of the longest joined to the neighbour that they turn
// least from, while there are more than four: a patch at each corner would be no more than a
// sliver.
std::vector<RegionSide> with_short_sides_joined(const NetworkFrame& frame,
                                                std::vector<RegionSide> sides);

// Where a side's edges begin and end on it, from 0 to 1: of one piece of a curve by parameters, so
// that the side is as smooth as the curve is; else by lengths.
std::vector<double> side_ends(const NetworkFrame& frame, const RegionSide& side);

// The sides with tangent ribbons. With C the side, over shares of its edges' lengths, n the normals
// along it and T = n × C' / |C'|, the ribbon is
//
//   α C' / |C'| + β T
//
// (Koelman 1999, (5.2)), where α and β are linear between those that the neighbouring sides' slopes
// have at the corners; the normal is brought to that of these slopes by a cubic without slope at
// the ends, where edges at a corner are off its plane. The frame must live as long.
std::vector<RibbonedSide> ribboned_sides(std::shared_ptr<const NetworkFrame> frame,
                                         const std::vector<RegionSide>& sides);

}  // namespace hull::network

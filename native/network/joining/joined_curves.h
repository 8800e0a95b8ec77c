// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "network/curves/network_curve.h"
#include "network/joining/curve_contacts.h"

namespace hull::network {

// Where a curve passes a node. At a knuckle the piece is the one that ends there.
struct NodeVisit {
  int curve, piece;
  double parameter;
  int node;
};

// A part of a piece of a curve between two nodes, with none between.
struct CurveEdge {
  int curve, piece;
  double low, high;
  int from, to;
};

struct JoinedCurves {
  std::vector<Vector3d> nodes;    // the mean of the places where curves meet
  std::vector<CurveEdge> edges;   // along each curve, in its order
  std::vector<NodeVisit> visits;  // along each curve, in its order
  std::vector<NetworkProblem> problems;
};

// Curves joined where they meet: at crossings, touches, and where an end is beside a curve or
// another end, all within the tolerance; a node, too, is each end and each knuckle. Meetings
// within the tolerance of one another along a curve are one node; so are two between which two
// curves are within it all the way.
//
// Named are gaps (curves that come as near as near_misses allows without being joined, with the
// places on both), stretches that curves share, and those that are the same. A curve that lies on
// another one all the way is not joined. A piece that crosses itself is not looked for.
// `contacts`: those of all the curves.
JoinedCurves join_curves(const std::vector<CurveShape>& shapes,
                         const std::vector<std::string>& names, const JoiningOptions& options,
                         const ContactTable& contacts);

}  // namespace hull::network

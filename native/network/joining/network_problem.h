// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/vectors.h"

namespace hull::network {

// What is to be told of a network: where, of which curves, and what to do about it.
struct NetworkProblem {
  enum class Kind {
    kShape,           // a curve that cannot be made
    kHalt,            // a curve without a direction somewhere
    kOffPlane,        // a point off the plane of its curve
    kGap,             // curves that nearly meet
    kShortEdge,       // two nodes of a curve that are nearly one
    kOverlap,         // a stretch that two curves share
    kDuplicate,       // of two curves all
    kDanglingEnd,     // of a curve, beyond the last one that it meets
    kApart,           // what is not connected with the rest
    kWrongOrder,      // edges that cannot be drawn on one surface
    kNoTangentPlane,  // at a node
    kTee,             // a curve that ends within another one's length, with surface beyond
    kFewSides,        // a region within one side
    kManySides,       // a region of more than ten
    kOpenRegion,      // of which there are no patches
    kLooseRegion,     // whose patches are not smooth with their neighbours
    kMissedCurve,     // that patches are off
  };
  Kind kind;
  std::string what;  // with the remedy
  std::vector<int> curves;
  std::vector<Vector3d> places;

  // Of a tee nothing has to be done.
  bool is_note() const { return kind == Kind::kTee; }
};

// As messages tell them: "(1.000, 2.000, 3.000) m", and "0.5 mm" of lengths below a metre.
std::string place_text(const Vector3d& place);
std::string length_text(double length);

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/arithmetic/bezier_net.h"

namespace hull::analysis {

// A part of a net's square [0, 1]^2.
struct NetSquare {
  BezierNet net;  // over the part
  double u, v, size;
};

// The parts into which a net is divided where it is zero. Zero counts as above.
struct NetCut {
  enum class Shape {
    kSimple,         // for each u there is at most one zero, not at a grazing angle
    kSimpleSwapped,  // for each v; the roles of u and v in the part's net are exchanged
    kTangled         // neither: near saddles and touching curves, once no more can be told apart
  };
  struct Part {
    NetSquare square;
    Shape shape;
  };
  std::vector<Part> parts;

  // Divides anew.
  void divide(const BezierNet& net);

 private:
  std::vector<NetSquare> level_, next_;  // tangled squares, kept for their memory
};

// Where zeros cross the border of a part, counter-clockwise from (0, 0).
struct SideCrossing {
  double u, v;
  bool enters;  // a curve that has what is above on its left
};
using SideCrossings = SmallList<SideCrossing, 12>;
SideCrossings side_crossings(const BezierNet& net);

// Which crossing that leaves follows each that enters: the curves of a tangled part, by what it can
// show of them. Pairs of indices.
using CrossingPairs = SmallList<std::array<int, 2>, 6>;
CrossingPairs pair_crossings(const BezierNet& net, const SideCrossings& crossings);

}  // namespace hull::analysis

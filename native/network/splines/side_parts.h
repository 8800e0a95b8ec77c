// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/patches/region_sides.h"

namespace hull::network {

// A part of an edge as a part of something's side: `from` and `to` are parameters of the edge.
struct EdgePiece {
  int edge;
  double from, to;
  double begin, end;  // of the side's parameter
};

// Where a region's side is made of which edge.
class SideParts {
 public:
  SideParts(const NetworkFrame& frame, RegionSide side);

  const RegionSide& edges() const { return side_; }
  const std::vector<double>& ends() const { return ends_; }
  // The edge at a parameter of the side, and its own parameter there.
  struct Place {
    RegionEdge edge;
    double parameter;
  };
  Place at(double t) const;
  // Where to cut the side in two: in the middle, to 1/1024 of the edge there, or at a node in the
  // middle half.
  double middle() const;
  // Of the part of the side between two parameters.
  std::vector<EdgePiece> pieces(double begin, double end) const;

 private:
  double edge_parameter(std::size_t part, double t) const;

  RegionSide side_;
  std::vector<double> ends_;
};

}  // namespace hull::network

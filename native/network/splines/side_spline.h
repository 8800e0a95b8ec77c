// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/splines/quad_fit.h"
#include "network/splines/side_parts.h"

namespace hull::network {

// The edges of a network as cubic splines.
struct EdgeSplines {
  std::vector<FittedSpline> fitted;  // by edges, along them

  // The place of an edge's parameter: bit for bit the same from whichever side.
  Vector3d place(const NetworkFrame& frame, int edge, double t) const;
};

EdgeSplines edge_splines(const NetworkFrame& frame, double tolerance);

// A side of a region as one spline, with the normals along it.
class SideSpline {
 public:
  SideSpline(std::shared_ptr<const NetworkFrame> frame, const EdgeSplines& splines,
             const RegionSide& side);

  const SideParts& parts() const { return parts_; }
  const BSplineCurve& curve() const { return curve_; }
  // Of the region's surface: the network's, made to be at right angles to the curve.
  Vector3d normal(double t) const;

 private:
  std::shared_ptr<const NetworkFrame> frame_;
  SideParts parts_;
  BSplineCurve curve_;
};

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "network/joining/joined_curves.h"

namespace hull::network {

// An edge over parameters from 0 to 1: the curve's part, brought to its nodes, which are up to the
// tolerance off, by cubics without slope at the ends, so that tangents at nodes are the curve's.
class EdgeShape {
 public:
  EdgeShape(const CurveEdge& edge, const NurbsCurve& piece, const Vector3d& from,
            const Vector3d& to);

  // The point and derivatives by the parameter up to an order from 0 to 2, a row each.
  Points3 evaluate(double u, int order) const;
  // The point of the curve itself.
  Vector3d given(double u) const;
  // Of the edge's beginning (in its direction) or end (against it): unit, from the node into it.
  const Vector3d& tangent_from(bool is_start) const {
    return is_start ? start_tangent_ : end_tangent_;
  }
  double length() const { return length_; }
  // Where the curve comes to a halt, or turns back at once, as far as 16 samples tell.
  const std::optional<Vector3d>& halt() const { return halt_; }

 private:
  Vector3d found_tangent(bool is_start) const;
  std::optional<Vector3d> found_halt() const;

  NurbsCurve piece_;
  double low_, high_;
  Vector3d from_shift_, to_shift_;
  double length_;
  Vector3d start_tangent_, end_tangent_;
  std::optional<Vector3d> halt_;
};

// What edges were, of curves of which some have changed since.
struct KnownEdges {
  const JoinedCurves* joined = nullptr;
  const std::vector<EdgeShape>* shapes = nullptr;
  std::vector<bool> is_changed;  // of the curves
};

// Those of curves that have not changed, between nodes that have not, are the known ones.
std::vector<EdgeShape> edge_shapes(const JoinedCurves& joined,
                                   const std::vector<CurveShape>& shapes,
                                   const KnownEdges& known = {});

}  // namespace hull::network

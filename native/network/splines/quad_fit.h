// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "conversion/patches/bspline_patch.h"
#include "network/splines/fitted_spline.h"

namespace hull::network {

// A side of a patch of four sides, counterclockwise seen from outside.
struct QuadSide {
  BSplineCurve curve;
  // By its parameter: what the surface's tangent plane is to be there, along the curve, too; unit.
  // None: whatever comes.
  std::function<Vector3d(double)> normal;
  // Where that holds; elsewhere, too, whatever comes. None: everywhere.
  std::function<bool(double)> has_normal = {};
};

// Points over the unit square that a patch is to pass near.
using QuadTarget = std::function<Vector3d(double, double)>;

// The bicubic B-spline patch within four sides, over their knots and those of `spans` equal spans
// each way: its borders are the sides', its derivative across a side is at right angles to the
// normals at the side's inner knots, and of all such patches it is that which in the mean of
// squares is nearest to the target. That is one linear least-squares problem with equality
// constraints: by Lagrange's multipliers, after the least squares without constraints, which part
// into those along u and along v.
//
// REQUIRES: each side begins in the point, bit for bit, in which the one before ends.
struct FittedQuad {
  conversion::BSplinePatch patch;
  bool has_normals = true;  // else they contradict one another, and it has what comes
};
FittedQuad fitted_quad(const std::array<QuadSide, 4>& sides, const QuadTarget& target, int spans);

}  // namespace hull::network

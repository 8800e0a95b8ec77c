// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/move_space.h"
#include "surface/creases/crease_curves.h"

namespace hull::modelling {

struct KnuckleOptions {
  std::vector<int> edges;                    // of the curve, rising; all where empty
  double tolerance = 0.0017453292519943296;  // rad: 0.1°
  int most_steps = 40;
};

// Control points that move, rising, and by what, m; and the angle that comes of it.
struct KnuckleSetting {
  std::vector<int> points;
  std::vector<Vector3d> moves;
  std::vector<int> edges;  // that were set: those asked for, but such as end in darts
  double deviation;        // largest, from the angle asked for, of 16 samples an edge, rad
  bool met;                // whether it is within the tolerance
  int steps;
};

// Moves the control points beside a knuckle so that its angle (surface/creases/knuckle_angle.h) is
// `angle`, in radians, along its edges. The curve itself stays: its own control points do not move,
// so that each side turns about it.
//
// Of all moves within the limits that bring the angle to what is wanted, in the mean square of four
// samples an edge, it is the one with the least Σ |move|²: by Gauss and Newton's iteration, x =
// Jᵀ (J Jᵀ + μ)^-1 (J x - e) for the angles' errors e and their exact derivatives J by the moves x,
// until moves stay. μ is 1e-6 of J Jᵀ's largest entry. One angle along an edge is as near as its
// control points allow; what is left is the deviation, on the exact surface.
//
// At a dart the angle is zero, so that an edge that ends in one is left out. Throws
// std::invalid_argument for what knuckle_edges() refuses, an angle outside of ±170°, where all
// edges are left out, no point beside them may move, or the surface has no tangent plane there.
KnuckleSetting set_knuckle_angle(const surface::LimitSurface& surface,
                                 const surface::CreaseCurve& curve, double angle,
                                 const ReshapeLimits& limits = {},
                                 const KnuckleOptions& options = {});

}  // namespace hull::modelling

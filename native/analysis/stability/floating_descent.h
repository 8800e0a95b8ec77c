// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/hull_body.h"
#include "analysis/stability/potential_energy.h"

namespace hull::analysis {

struct FloatingTask {
  double volume = 0.0;  // m³, to be displaced
  Vector3d centre_of_gravity = Vector3d::Zero();
  FreeRotations free;
  // Of the displaced volume, relative, and of the lever between weight and buoyancy over the
  // control mesh's size.
  double tolerance = 1e-11;
  int most_iterations = 100;
};

struct Descent {
  enum class End {
    kEquilibrium,  // both residuals are within the tolerance, or as small as rounding lets them
    kOnEnd,        // the trim went beyond 90° with the heel held
    kStuck,        // no step lowers the energy any more
    kTooManySteps,
  } end = End::kTooManySteps;
  double trim = 0.0, heel = 0.0;
  Immersion immersion;
  double volume_residual = 0.0;  // (V - ∇) / ∇
  double lever_residual = 0.0;  // m: horizontal distance of G and B, in the rotations that are free
  int iterations = 0;           // steps tried
  int evaluations = 0;          // immersions computed
};

// Minimises the potential energy (potential_energy.h) from the given water by Newton's method with
// exact derivatives in a trust region (Conn, Gould and Toint 2000, chapter 6), bounded along each
// axis of the stiffness by itself: a step is kept if it lowers the energy, and the region grows and
// shrinks with how well the quadratic model foretold by how much. Where the energy is not convex
// steps go downhill to the region's bound. Ends at a minimum, or at a saddle if there is one
// exactly ahead, as that of an upright ship without stability.
Descent descend(const HullBody& body, const FloatingTask& task, double trim, double heel,
                double offset);

}  // namespace hull::analysis

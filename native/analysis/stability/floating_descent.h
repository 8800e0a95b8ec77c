// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// The rest of a floating body as a minimum of potential energy. For water n·x = c, displaced volume
// ∇ wanted, centre of gravity G, immersed volume V with its centre B, the energy over density and
// gravity is
//
//   U(n, c) = ∇ (n·G - c) - V (n·B - c).
//
// It is convex in c with ∂U/∂c = V - ∇. Turning the plane about an axis through the centre of
// flotation F, with dn the change of the normal, gives
//
//   ∂U = dn·w,  ∂²U = dnᵀ S dn + d²n·w,  w = ∇ (G - F) - V (B - F),
//
// S the waterplane's second moments about F; and no term that mixes turning and sinking.

// How the water may turn in the ship's axes.
struct Freedom {
  bool trim = true, heel = true;
};

// The ways the plane's normal may go from where it is, as columns; beside them the curvature v of
// these ways: d²n = -|p|² v for a step p. Both free: the steps are orthonormal, forward and to the
// side that goes up.
struct Turning {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> ways;
  Vector3d curvature;
};
Turning turning(double trim, double heel, Freedom freedom);

// The energy's second derivatives by steps along the ways, the body sinking or rising to keep its
// volume; m⁴.
Eigen::MatrixXd turning_stiffness(const Turning& turning, const Immersion& immersion,
                                  const Vector3d& w);
// F of above; without a waterplane the point of the water's surface under the centre of gravity.
Vector3d turning_point(const Immersion& immersion, const Vector3d& gravity_centre);
// w of above, m⁴.
Vector3d turning_moment(const Immersion& immersion, const Vector3d& point, double volume,
                        const Vector3d& gravity_centre);

struct FloatingTask {
  double volume = 0.0;  // m³, to be displaced
  Vector3d centre_of_gravity = Vector3d::Zero();
  Freedom freedom;
  // Of the displaced volume, relative, and of the lever between weight and buoyancy over the
  // control mesh's size.
  double tolerance = 1e-11;
  int most_iterations = 100;
};

struct Descent {
  enum class End {
    kRest,   // both residuals are within the tolerance, or as small as rounding lets them
    kOnEnd,  // the trim went beyond 90° with the heel held
    kStuck,  // no step lowers the energy any more
    kTooManySteps,
  } end = End::kTooManySteps;
  double trim = 0.0, heel = 0.0;
  Immersion immersion;
  double volume_residual = 0.0;  // (V - ∇) / ∇
  double lever_residual = 0.0;   // m: horizontal distance of G and B, in the ways that are free
  int iterations = 0;            // steps tried
  int evaluations = 0;           // immersions computed
};

// Newton's method with the exact derivatives above on the energy from the given water; a step is
// kept if it lowers the energy, and no longer than where the last ones were trusted. Along ways in
// which the energy is not convex it goes downhill. Ends at a minimum, or at a saddle if there is
// one exactly ahead, as that of an upright ship without stability.
Descent descend(const HullBody& body, const FloatingTask& task, double trim, double heel,
                double offset);

// The smallest and greatest height of the control points, both sides, along a direction: no part of
// the body is outside.
struct Span {
  double low, high;
};
Span span_along(const HullBody& body, const Vector3d& direction);

// Volume of the body when it is wholly under water.
double greatest_volume(const HullBody& body, const Vector3d& up);

// The water with the given normal in which the body displaces the volume, to an error of
// `tolerance` of it or of what is above water, if that is less. REQUIRES: 0 < volume <
// greatest_volume(). Counts its immersions.
double offset_of_volume(const HullBody& body, const Vector3d& up, double volume,
                        double whole_volume, double tolerance, int& evaluations);

}  // namespace hull::analysis

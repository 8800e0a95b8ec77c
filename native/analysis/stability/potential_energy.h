// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "analysis/immersion/immersion.h"

namespace hull::analysis {

// The potential energy of a floating body and its exact derivatives: equilibria are its stationary
// points, stable ones its minima. For water n·x = c, displaced volume ∇ wanted, centre of gravity
// G, immersed volume V with its centre B, the energy over density and gravity is
//
//   U(n, c) = ∇ (n·G - c) - V (n·B - c).
//
// It is convex in c with ∂U/∂c = V - ∇. Rotating the plane about an axis through the centre of
// flotation F, with dn the change of the normal, gives
//
//   ∂U = dn·w,  ∂²U = dnᵀ S dn + d²n·w,  w = ∇ (G - F) - V (B - F),
//
// S the waterplane's second moments about F; and no term that mixes rotation and sinkage.

// U of above, m⁴.
double potential_energy(const Immersion& immersion, double volume,
                        const Vector3d& centre_of_gravity);

// The rotations that are free; the others are held.
struct FreeRotations {
  bool trim = true, heel = true;
};

// The directions in which the plane's normal may go from where it is, as columns: none, one or two;
// beside them the curvature v of these paths: d²n = -|p|² v for a step p. Both free: the steps are
// orthonormal, forward and to the side that goes up. Heel alone keeps the x of the normal: its
// column has the length cos(trim).
struct NormalDirections {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> columns;
  Vector3d curvature;
};
NormalDirections normal_directions(double trim, double heel, FreeRotations free);

// F of above; without a waterplane the point of the water's surface under the centre of gravity.
Vector3d rotation_centre(const Immersion& immersion, const Vector3d& centre_of_gravity);

// w of above, m⁴, about a point F.
Vector3d rotation_moment(const Immersion& immersion, const Vector3d& point, double volume,
                         const Vector3d& centre_of_gravity);

// The energy's second derivatives by steps along the directions, the body sinking or rising to keep
// its volume; m⁴. Over the volume they are metacentric heights.
Eigen::MatrixXd rotation_stiffness(const NormalDirections& directions, const Immersion& immersion,
                                   const Vector3d& moment);

}  // namespace hull::analysis

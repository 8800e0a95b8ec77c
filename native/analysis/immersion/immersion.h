// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/shell_moments.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// What the water does to a body that lies in it: the displaced volume and the waterplane, in the
// body's own axes.
struct Immersion {
  Plane water;
  double volume = 0.0;                              // m³
  Vector3d centre_of_buoyancy = Vector3d::Zero();   // m; zero if nothing is immersed
  double wetted_surface = 0.0;                      // m²
  double waterplane_area = 0.0;                     // m²
  Vector3d centre_of_flotation = Vector3d::Zero();  // m, in the plane; zero without waterplane
  Eigen::Matrix3d waterplane_second = Eigen::Matrix3d::Zero();  // ∫ (q - F)(q - F)ᵀ dA, m⁴: q in
                                                                // the waterplane, F its centre
  Vector3d flux_forms = Vector3d::Zero();  // m³: ∫ x n_x, ∫ y n_y, ∫ z n_z over the immersed
                                           // surface alone: tests of its closedness
  double volume_error = 0.0;               // estimates of the quadrature's errors, m³, m²
  double wetted_surface_error = 0.0;
};

// From the moments of what is below the water of a closed body's shell, about the origin. The flux
// forms, of the shell without closings, are left at zero. For accuracy the origin should be near
// the water's surface.
Immersion immersion_of(const ShellMoments& wet, const Plane& water);

}  // namespace hull::analysis

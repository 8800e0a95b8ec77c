// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/plane_cut.h"

namespace hull {

// Integrals over the part of a surface below a plane, n the outward normal, h the height above the
// plane along its normal e, p the position:
struct ImmersedIntegrals {
  double wetted_area = 0.0;                 // ∫ dS, m²
  double flux = 0.0;                        // ∫ h e·n dS, m³: the displaced volume
  Vector3d flux_moment = Vector3d::Zero();  // ∫ (p - h/2 e) h e·n dS, m⁴: its first moments
  double projected_area = 0.0;              // -∫ e·n dS, m²: the waterplane area
  Vector3d projected_moment = Vector3d::Zero();  // -∫ q e·n dS, m³, q: p projected on the plane
  Eigen::Matrix3d projected_second = Eigen::Matrix3d::Zero();  // -∫ q qᵀ e·n dS, m⁴
  Vector3d flux_forms = Vector3d::Zero();  // ∫ x n_x dS, ∫ y n_y dS, ∫ z n_z dS, m³
  double wetted_area_error = 0.0;          // estimates of the quadrature's error
  double flux_error = 0.0;

  ImmersedIntegrals& operator+=(const ImmersedIntegrals& other);
};

// Polynomial integrands are integrated exactly over pieces that are wholly immersed, and by Gauss
// quadrature between the exact crossings of the plane where cut (error about 1e-12 of the whole);
// the wetted area, not polynomial, to about 1e-9 of the size squared. Rings around irregular knots
// are summed until what is left is smaller than 1e-8 of the mesh's size.
//
// The flux forms hold the volume where the openings are closed by the plane itself and by planes
// that the direction in question lies in: e·n for vertical openings and an upright plane.
// flux_forms = (∫ x n_x, ∫ y n_y, ∫ z n_z) over the immersed part, the last without the plane's
// share.
ImmersedIntegrals immersed_integrals(const LimitSurface& surface, const Plane& water);

}  // namespace hull

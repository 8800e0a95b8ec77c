// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "mesh/vectors.h"

namespace hull::analysis {

// Integrals over a piece of surface, p the position, n the unit normal. Everything that water does
// to an immersed piece follows from them, whatever the water's level and direction; so they are
// computed once and added up.
struct ShellMoments {
  double area = 0.0;                                // ∫ dS, m²
  double area_error = 0.0;                          // estimate, m²
  double volume_error = 0.0;                        // estimate of the error of ∫ h e·n, m³
  Vector3d normal = Vector3d::Zero();               // ∫ n dS, m²
  Eigen::Matrix3d first = Eigen::Matrix3d::Zero();  // ∫ p nᵀ dS, m³
  // ∫ s nᵀ dS, m⁴, s the products x x, y y, z z, x y, y z, z x.
  Eigen::Matrix<double, 6, 3> second = Eigen::Matrix<double, 6, 3>::Zero();

  ShellMoments& operator+=(const ShellMoments& other);
  ShellMoments& operator*=(double factor);

  // ∫ p pᵀ (e·n) dS.
  Eigen::Matrix3d second_along(const Vector3d& e) const;
};

// Those of the piece moved by `shift`, and of its mirror image in y = 0, turned outwards again.
ShellMoments moved(const ShellMoments& moments, const Vector3d& shift);
ShellMoments mirrored(const ShellMoments& moments);

}  // namespace hull::analysis

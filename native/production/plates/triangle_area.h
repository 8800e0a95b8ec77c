// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/shell_mesh.h"

namespace hull::production {

// ∫ dA and ∫ p dA of a part of the surface, m² and m³.
struct AreaMoments {
  double area = 0.0;
  Vector3d moment = Vector3d::Zero();

  AreaMoments& operator+=(const AreaMoments& other) {
    area += other.area;
    moment += other.moment;
    return *this;
  }
};

// Of the surface over a triangle of (u, v), by Gauss's quadrature on its parts in each piece of the
// surface, which are quartered until that changes no more than `tolerance`, m².
AreaMoments area_moments(const surface::LimitSurface& surface, const ShellTriangle& triangle,
                         double tolerance);

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "surface/curvature.h"
#include "surface/sampling/tessellation.h"

namespace hull::analysis {

// What is shown of a surface at its points.
enum class FieldKind {
  kGaussian,  // curvature, 1/m²
  kMean,      // 1/m, as are …
  kMaximum,   // … the larger and …
  kMinimum,   // … the smaller principal curvature
  kSlope,     // angle between the normal and a direction, radians
  kDistance   // from another surface, m, positive outside: only shown, not computed here
};

// At places of the surface, of any kind but a distance. `direction`, a unit vector, is for the
// slope only. Curvature at irregular knots is that beside them (see curvature()); NaN where there
// is no tangent plane.
std::vector<double> surface_field(const surface::LimitSurface& surface,
                                  const std::vector<int>& cells,
                                  const std::vector<Eigen::Vector2d>& uv, FieldKind kind,
                                  const Vector3d& direction);

// One value for each of the tessellation's normals, so that both sides of a crease have their own.
// At irregular knots, where curvature may diverge, and where it is undefined, it is the mean of the
// neighbours along quadrilaterals that have a value of their own.
std::vector<double> surface_field(const surface::LimitSurface& surface,
                                  const surface::Tessellation& tessellation, FieldKind kind,
                                  const Vector3d& direction);

// A function of a point and the unit normal there, for each normal of the tessellation; NaN where
// there is no normal.
using NormalFunction = std::function<double(const Vector3d& point, const Vector3d& normal)>;
std::vector<double> normal_field(const surface::Tessellation& tessellation,
                                 const NormalFunction& function);

// The area (m²) that each normal of a tessellation stands for: a quarter of its quadrilaterals'.
std::vector<double> field_weights(const surface::Tessellation& tessellation);

}  // namespace hull::analysis

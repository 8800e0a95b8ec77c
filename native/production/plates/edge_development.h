// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/surface_curve.h"

namespace hull::production {

// How the tangent plane at a point of the surface lies on the drawing plane: the unit tangent
// `along` of the surface is at `angle` there, counter-clockwise as seen from the water; the point
// itself is at `at`.
struct PlaneFrame {
  Vector3d along;
  double angle;
  Eigen::Vector2d at;
};

// The frame at the start of a step, of any orientation.
PlaneFrame first_frame(const surface::LimitSurface& surface, const CurveStep& step);

// The frame at the end of the step: the surface rolled onto the plane along it. With e1 the unit
// tangent nearest to the start's and e2 = n x e1, the angle of e1 on the plane and the point there
// change by
//
//   θ' = e1' · e2,   x' = R(θ) (S' · e1, S' · e2)
//
// (do Carmo 1976, 4-4: Levi-Civita's parallel transport), by Gauss's collocation with eight points.
// Lengths and geodesic curvatures along the step are kept; where the surface is developable the end
// does not depend on the way. REQUIRES: the surface turns by less than a right angle.
PlaneFrame rolled(const surface::LimitSurface& surface, const CurveStep& step,
                  const PlaneFrame& start);

}  // namespace hull::production

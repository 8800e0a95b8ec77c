// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/queries/surface_tree.h"

namespace hull::surface {

// A minimum of |S - p| over the unit square: a point of the surface, whether or not the steps came
// to an end.
struct PatchMinimum {
  double u, v;
  SurfaceJet jet;
  double distance;
  bool settled;
};

// Damped Newton steps in the square from (u, v), coordinates at a bound kept there while the
// distance falls outwards. scale: the size of the surface's coordinates, m.
PatchMinimum minimise(const BezierPatch& patch, const Vector3d& p, double u, double v,
                      double scale);

// Where to begin: the foot on the tangent plane in the middle.
Eigen::Vector2d first_guess(const BezierPatch& patch, const Vector3d& p);

}  // namespace hull::surface

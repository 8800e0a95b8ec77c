// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/vectors.h"
#include "surface/creases/cubic_spline.h"

namespace hull::modelling {

// A point, and two derivatives by t, of a cubic arc with these Bézier points, for t from 0 to 1.
surface::CurveJet arc_jet(const std::array<Vector3d, 4>& arc, double t);

// Not more than the distance of a point from the arc, m: that from the box of its Bézier points.
double least_distance(const std::array<Vector3d, 4>& arc, const Vector3d& p);

struct ArcFoot {
  double t, distance;  // m
};

// The point of the arc that is nearest to p, if it is nearer than `most`, m; else a distance of
// `most`. The minimum is global: parts of the arc are left out only where the Bézier coefficients
// of the squared distance prove that they are farther, and a local minimum is taken for the only
// one only where these prove it convex.
ArcFoot arc_foot(const std::array<Vector3d, 4>& arc, const Vector3d& p, double most);

}  // namespace hull::modelling

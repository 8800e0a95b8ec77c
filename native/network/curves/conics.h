// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "network/curves/nurbs_curve.h"

namespace hull::network {

// Arcs of conics as rational quadratic curves (Piegl and Tiller 1987; Koelman 1999, 5.2.1). All
// throw std::invalid_argument for points that do not make one, with the reason.

// From start to end, where its tangents meet in `apex`. With M the middle between the ends and S
// the shoulder, where the arc crosses the line from M to the apex, fullness is |MS| / |S apex|:
// below 1 an ellipse, 1 a parabola, above 1 a hyperbola.
NurbsCurve conic_arc(const Vector3d& start, const Vector3d& apex, const Vector3d& end,
                     double fullness);

// Where the lines from both ends along unit directions are nearest to one another: the middle of
// those two places, and how far apart they are, m. None where the lines are parallel.
struct Apex {
  Vector3d place;
  double apart;
};
std::optional<Apex> apex_of(const Vector3d& start, const Vector3d& along, const Vector3d& end,
                            const Vector3d& back);

// The circular arc from start to end by way of a point; in parts of at most a quarter circle.
NurbsCurve arc_through(const Vector3d& start, const Vector3d& point, const Vector3d& end);

// The circular arc that leaves start in a direction.
NurbsCurve arc_from_tangent(const Vector3d& start, const Vector3d& direction, const Vector3d& end);

}  // namespace hull::network

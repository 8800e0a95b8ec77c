// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/creases/crease_curves.h"

namespace hull::surface {

// The angle of a knuckle, in radians within [-π, π]: between the surface's normals on both sides of
// the curve's point t. Zero where the surface is smooth, positive where it is bent away from the
// water, as a chine is; negative in a hollow. NaN where a side has no face or no tangent plane, or
// the curve no direction. REQUIRES: as CreaseCurve::evaluate().
double knuckle_angle(const LimitSurface& surface, const CreaseCurve& curve, double t);

// The same of two unit normals and a direction along the curve, of any length.
double angle_between(const Vector3d& left, const Vector3d& right, const Vector3d& along);

// The control edges of a knuckle that are named, or all of the curve where none are. Throws
// std::invalid_argument for a border, which has a surface on one side only, and for edges that the
// curve does not have or that do not rise.
std::vector<int> knuckle_edges(const CreaseCurve& curve, const std::vector<int>& edges);

}  // namespace hull::surface

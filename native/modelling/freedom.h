// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::modelling {

// A control point may move across this direction only. Several may be given for one point.
struct HeldDirection {
  int point;
  Vector3d normal;  // of any length but zero
};

// What stays while control points are moved to change the surface.
struct MoveLimits {
  std::vector<int> locked;          // control points
  std::vector<HeldDirection> held;  // points of a flat region, across its plane
};

// The orthonormal directions a control point may move in.
struct Freedom {
  std::array<Vector3d, 3> directions;
  int count;
};

// Throws std::invalid_argument, naming what the point is meant to be, unless it is one of `count`.
void check_point(int point, int count, const char* what);

// What each of `point_count` control points may do within the limits: axes stay axes where planes
// are square to them. Throws std::invalid_argument for points or normals that are none.
std::vector<Freedom> freedoms_within(const MoveLimits& limits, int point_count);

}  // namespace hull::modelling

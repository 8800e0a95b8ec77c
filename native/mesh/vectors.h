// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

// Points and directions in all layers, in space and in a plane.
namespace hull {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Above zero where b points to the left of a.
inline double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace hull

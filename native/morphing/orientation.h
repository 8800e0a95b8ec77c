// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hull::morphing {

using Eigen::Vector2d;

// Twice the signed area of the triangle a, b, c: positive where it turns to the left. Its sign, and
// whether it is zero, are exact (Shewchuk 1997); its value is within 1e-13 of itself.
//
// orientation(b, a, c) is -orientation(a, b, c) bit by bit.
//
// REQUIRES: coordinates of less than 1e150, and products of two of them that are zero or more than
// 1e-280.
double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c);

}  // namespace hull::morphing

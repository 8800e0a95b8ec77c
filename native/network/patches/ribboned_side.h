// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "mesh/vectors.h"

namespace hull::network {

// A side of a patch at a parameter from 0 to 1: the point, how it moves on along the side
// (`slope`), the ribbon (the derivative of the surface across the side, into the patch), and how
// that moves on, and how the slope does (`bend`).
struct SideJet {
  Vector3d point, slope, ribbon, ribbon_slope, bend;
};

// Sides run counterclockwise around a patch, seen from outside. Where two meet, what one's ribbon
// is, is the other's slope: at its start a side's ribbon is that of the one before, taken
// backwards; at its end that of the one after.
using RibbonedSide = std::function<SideJet(double)>;

using Vector2d = Eigen::Vector2d;

// A point of a patch, and its derivatives by the two coordinates of the patch's domain.
struct PatchPoint {
  Vector3d point, by_first, by_second;

  // Unit, outwards.
  Vector3d normal() const { return by_first.cross(by_second).normalized(); }
};

}  // namespace hull::network

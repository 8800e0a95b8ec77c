// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull {

enum class Axis { kX, kY, kZ };

// One branch of the intersection of a surface with a plane.
struct SectionCurve {
  std::vector<Vector3d> points;     // in order; on surface and plane to 1e-10 of the mesh's size
  std::vector<int> cells;           // per point …
  std::vector<Eigen::Vector2d> uv;  // … and where in that cell
  std::vector<int> knuckles;        // indices of points on creases
  bool closed = false;              // the first point is then repeated at the end
};

// The intersection with the plane across `axis` at `position` (m), branch by branch. Points follow
// the curve so closely that no chord is further than `chord_tolerance` (m) from it.
//
// A surface that lies in the plane, or touches it from the side of larger coordinates, has no
// section there: zero height counts as above. So a half hull has no section at y = 0; its profile
// is its border. Where the plane is tangent to the surface at a saddle, branches meet within 1e-3
// of a cell.
//
// Throws std::invalid_argument unless position is finite and chord_tolerance positive.
std::vector<SectionCurve> section(const LimitSurface& surface, Axis axis, double position,
                                  double chord_tolerance);
std::vector<SectionCurve> section(const LimitSurface& surface, const Plane& plane,
                                  double chord_tolerance);

}  // namespace hull

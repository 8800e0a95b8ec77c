// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/sections/plane_cut.h"
#include "analysis/sections/sections.h"
#include "bindings/arrays.h"

namespace hull::bindings {

// Of the mesh's size, unless given: how far chords may be from the curve that they are drawn for.
inline constexpr double kChordTolerance = 1e-5;

// "x", "y" or "z"; raises ValueError for anything else.
analysis::Axis axis_from(const std::string& name);

// The plane normal·x = offset, for a normal of any length. Raises ValueError, with the name, for
// what is no plane.
analysis::Plane plane_from(const Vector3d& normal, double offset, const std::string& name);
// (4,) -> a plane: normal, of any length, and offset.
analysis::Plane plane_from(const DoubleArray& array, const char* name);
// (n, 4) -> n planes.
std::vector<analysis::Plane> planes_from(const DoubleArray& array);

// (4,), the normal of unit length.
py::array_t<double> to_array(const analysis::Plane& plane);

}  // namespace hull::bindings

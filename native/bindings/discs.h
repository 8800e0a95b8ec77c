// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bindings/arrays.h"
#include "morphing/orientation.h"
#include "morphing/parametrisation/triangle_disc.h"

// Arrays of triangles and of places in a plane, as those of arrays.h.
namespace hull::bindings {

// (n, 3) of whole numbers.
std::vector<morphing::Triangle> triangles_from(const py::object& array, const char* name);
// (n, 2) of numbers.
std::vector<morphing::Vector2d> places_from(const DoubleArray& array, const char* name);

py::array_t<int> triangle_array(const std::vector<morphing::Triangle>& triangles);

}  // namespace hull::bindings

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bindings/arrays.h"
#include "modelling/freedom.h"

namespace hull::bindings {

// locked (n,), held_points (h,) and held_normals (h, 3), as given to what moves control points.
modelling::MoveLimits limits_from(const py::object& locked, const py::object& held_points,
                                  const DoubleArray& held_normals);

}  // namespace hull::bindings

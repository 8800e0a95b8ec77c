// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bindings/arrays.h"
#include "modelling/freedom.h"
#include "modelling/reshape/reshape.h"

namespace hull::bindings {

// locked (n,), held_points (h,) and held_normals (h, 3), as given to what moves control points.
modelling::MoveLimits limits_from(const py::object& locked, const py::object& held_points,
                                  const DoubleArray& held_normals);

// tied (t, 2), points with their leaders, and tied_directions (t, 3).
std::vector<modelling::TiedPoint> ties_from(const py::object& tied, const DoubleArray& directions);
// Tuples (control points (k,), slopes (k, 3)); `what` names them in messages.
std::vector<modelling::MoveCondition> conditions_from(const py::iterable& conditions,
                                                      const std::string& what);

}  // namespace hull::bindings

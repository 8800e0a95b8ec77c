// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bindings/arrays.h"
#include "modelling/freedom.h"
#include "modelling/reshape/reshape.h"

namespace hull::bindings {

// As given to what moves control points: locked (n,), held_points (h,) and held_normals (h, 3);
// tied (t, 2), points with their leaders, and tied_directions (t, 3); kept as for
// conditions_from().
modelling::ReshapeLimits limits_from(const py::object& locked, const py::object& held_points,
                                     const DoubleArray& held_normals, const py::object& tied,
                                     const DoubleArray& tied_directions, const py::iterable& kept);
// Tuples (control points (k,), slopes (k, 3)); `what` names them in messages.
std::vector<modelling::MoveCondition> conditions_from(const py::iterable& conditions,
                                                      const std::string& what);

}  // namespace hull::bindings

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bindings/arrays.h"
#include "modelling/reshape/move_space.h"

namespace hull::bindings {

// tied (t, 2) and tied_directions (t, 3), as given to what moves control points.
std::vector<modelling::TiedPoint> ties_from(const py::object& tied, const DoubleArray& directions);

}  // namespace hull::bindings

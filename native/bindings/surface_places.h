// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bindings/arrays.h"
#include "modelling/reshape/surface_places.h"

namespace hull::bindings {

// (k, 3, 3) -> k gradients of a shift.
std::vector<Eigen::Matrix3d> gradients_from(const DoubleArray& array);

// One row, or number, a place.
py::array_t<double> positions(const modelling::SurfacePlaces& places);
py::array_t<int> cells(const modelling::SurfacePlaces& places);
py::array_t<double> areas(const modelling::SurfacePlaces& places);

}  // namespace hull::bindings

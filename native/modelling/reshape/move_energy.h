// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// What moves of control points cost, as forms of one coordinate of the moves: control points x
// control points, the same for x, y and z.

// The mean, by area, of the squared shift of the surface.
Eigen::SparseMatrix<double> mean_square_form(const SurfacePlaces& places);

// The thin-plate energy of the moves (thin_plate.h) times a factor. `forms`: those of the surface's
// topology.
Eigen::SparseMatrix<double> thin_plate_form(const surface::LimitSurface& surface,
                                            const surface::SquareForms& forms, double factor);

// The form of one coordinate, for points' x, y and z in turn.
Eigen::SparseMatrix<double> for_all_axes(const Eigen::SparseMatrix<double>& form);

}  // namespace hull::modelling

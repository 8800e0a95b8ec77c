// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "modelling/fairing/surface_energy.h"
#include "modelling/thin_plate.h"
#include "surface/limit_surface.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// Of moves Δ of control points: constant + 2 gradient · Δ + Δᵀ matrix Δ, by (x, y, z) of each.
struct QuadraticEnergy {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd gradient;
  double constant = 0.0;
};

// A form of numbers, one a control point, as that of vectors: the same along each axis.
Eigen::SparseMatrix<double> along_each_axis(const std::vector<Eigen::Triplet<double>>& entries,
                                            Eigen::Index size);

// Calls visit for forms of some pieces whose sum is the energy of the surface's places.
// REQUIRES: energy is kLengthwise, kThinPlate or kBlend, those that are quadratic.
void visit_energy_forms(const surface::LimitSurface& surface, const surface::PieceWeights& weights,
                        const std::vector<int>& some, FairEnergy energy, const VisitForm& visit);

// The same as one energy of moves; the matrix: of control points only for which `counts` is not 0.
// Throws std::invalid_argument where kBlend has no cell that tells of these.
QuadraticEnergy quadratic_energy(const surface::LimitSurface& surface,
                                 const surface::PieceWeights& weights, const std::vector<int>& some,
                                 FairEnergy energy, const std::vector<char>& counts);

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "modelling/fit/fit_equations.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// The thin-plate energy of the exact surface, ∫ |second derivatives|² dA, of something that the
// control points carry, `values`: of their places it is ∫ κ1² + κ2² dA (a number: a sphere has 8π);
// of moves it is what these bend the surface by, to second order, along it as well as across.
//
// Derivatives are to the surface's own metric (covariant ones), so that uneven distances of points
// cost nothing. By Gauss quadrature on the pieces; squares of 2^-kPlainRings of a cell at irregular
// knots, and pieces without area, are left out; nothing is counted across creases.
//
// REQUIRES: as many values as control points.
double thin_plate_energy(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                         const std::vector<Vector3d>& values);

// Adds `factor` times that energy to the equations for what is added to the values.
void add_thin_plate(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                    const std::vector<Vector3d>& values, double factor, FitEquations& equations);

// The same energy as a form of all control points: of what they carry it is Σ valueᵀ · form ·
// value, over x, y and z.
Eigen::SparseMatrix<double> thin_plate_matrix(const surface::LimitSurface& surface,
                                              const surface::PieceWeights& pieces);

// The same energy of one piece, as a form of its 16 B-spline points.
Eigen::Matrix<double, 16, 16> thin_plate_of_span(const surface::BicubicPoints& points);

// Is told control points and their quadratic form.
using VisitForm = std::function<void(const std::vector<int>&, const Eigen::MatrixXd&)>;

// Calls visit(control points, their quadratic form) for each piece: `factor` times the energy is
// the sum of valuesᵀ · form · values.
void visit_thin_plate_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, double factor,
                            const VisitForm& visit);
// The same for some pieces.
void visit_thin_plate_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, const std::vector<int>& some,
                            double factor, const VisitForm& visit);

// The same, for some pieces, of what bends along the ship alone: ∫ |second derivative along d|² dA,
// d the part of the x axis along the surface (shorter than 1 where that looks ahead or aback). Of
// the surface's places it is ∫ h(d, d)² dA, h the second fundamental form.
void visit_lengthwise_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, const std::vector<int>& some,
                            const VisitForm& visit);

}  // namespace hull::modelling

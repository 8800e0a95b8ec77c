// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vectors.h"
#include "modelling/fairing/quadratic_energy.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// What bends of a surface are compared with: those of another one of the same mesh, at places of
// the same parameters.
struct BendsBefore {
  std::vector<Vector3d> points;  // control points of that other surface
  // 1/m: a bend that is less may change by as much as this one before it costs more.
  double least = 0.0;
  // Places on that surface and how much more changes cost within `reach` of each, m; where several
  // are near the largest counts.
  std::vector<Vector3d> emphasised;
  std::vector<double> factors;
  double reach = 0.0;
};

// How much a surface bends otherwise than before, in proportion to how much it did:
//
//   ∫ Σ_ab (h_ab - b_ab)² r² / (b_ab² + r²) dA,
//
// h its second fundamental form, b that of the surface before, both in the frame of the part of the
// x axis along the own surface and of what is across it, r the least bend. So bends keep their
// sides and their order where the surface is shaped anew, straight parts above all. Second
// derivatives are to the metric of the surface as it is (thin_plate.h), hence quadratic in moves;
// what moves bend along the surface costs a tenth of that, so that points do not crowd.
//
// Summed over some pieces. Places where either surface has no area, or looks ahead or aback, are
// left out. The matrix: of control points only for which `counts` is not 0.
// Throws std::invalid_argument where `before` has not as many points as the surface, or not a
// factor for each place, or where the least bend or a factor is not above zero.
QuadraticEnergy bend_change(const std::vector<Vector3d>& points, const BendsBefore& before,
                            const surface::PieceWeights& weights, const std::vector<int>& pieces,
                            const std::vector<char>& counts);

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/thin_plate.h"
#include "surface/pieces/bicubic.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// Of the uniform cubic B-spline basis, all along a span.
inline constexpr surface::Basis kThirdDerivative{-1.0, 3.0, -3.0, 1.0};

// How far a surface is from one that is blended from its rows along and across, as a form for each
// piece: ∫ |∂⁶S/∂u³∂v³|² du dv, m², u and v along the sides of a cell, 1 on each.
//
// Whatever bends along one row, however much, costs nothing while it changes across evenly, and the
// other way round: none have the surfaces Σ uᵏ f_k(v) + vᵏ g_k(u), k = 0, 1, 2, with any f and g.
// These obey the draftsman's equation of that order (Birkhoff and Gordon 1968). What is in one row
// or few alone, such as a dent or a wave along a bilge, has much. It is the highest derivative that
// bicubic pieces have, a constant of each, and it is the same whichever side of a cell is u.
//
// Cells that are no single piece, those at irregular knots, are left out: their derivatives grow
// without bound towards the knot. A control point that has no other cell has no part in it.
void visit_blend_forms(const surface::PieceWeights& pieces, const std::vector<int>& some,
                       const VisitForm& visit);

}  // namespace hull::modelling

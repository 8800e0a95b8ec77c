// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit_equations.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling::fit_internal {

// A place of the surface that is wanted `distance` farther along `direction`.
struct FitRow {
  int cell;
  double u, v;
  Vector3d direction;
  double distance;
  double weight;  // of its square
};

// Adds all rows' weighted squares to the equations.
void add_rows(const std::vector<FitRow>& rows, const surface::LimitSurface& surface,
              const surface::PieceWeights& pieces, FitEquations& equations);

}  // namespace hull::modelling::fit_internal

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit_equations.h"
#include "surface/piece_weights.h"

namespace hull::fit_internal {

// A place of the surface that is wanted `distance` farther along `direction`.
struct FitRow {
  int cell;
  double u, v;
  Vector3d direction;
  double distance;
  double weight;  // of its square
};

// Adds all rows' weighted squares to the equations.
void add_rows(const std::vector<FitRow>& rows, const LimitSurface& surface,
              const PieceWeights& pieces, FitEquations& equations);

}  // namespace hull::fit_internal

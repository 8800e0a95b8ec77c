// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit.h"
#include "modelling/fit/fit_equations.h"
#include "surface/pieces/piece_weights.h"
#include "surface/queries/surface_tree.h"

namespace hull::modelling::fit_internal {

// A target and the surface's closest point to it.
struct Foot {
  int cell = -1;  // -1: the target is left out
  double u = 0.0, v = 0.0;
  Vector3d point = Vector3d::Zero();
  Vector3d direction = Vector3d::Zero();  // of length 1, across the surface
  double distance = 0.0;                  // along it
};

struct Feet {
  std::vector<Foot> all;     // as the targets
  double mean_square = 0.0;  // by their weights
  double weight = 0.0;       // the sum of those that count
};

Feet find_feet(const surface::LimitSurface& surface, const surface::SurfaceTree& tree,
               const FitTarget& target, const FitOptions& options);

// Adds the mean square of the distances, each along its direction.
void add_feet(const Feet& feet, const FitTarget& target, const surface::LimitSurface& surface,
              const surface::PieceWeights& pieces, FitEquations& equations);

}  // namespace hull::modelling::fit_internal

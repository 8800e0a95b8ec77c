// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/targets/targets.h"
#include "morphing/families/hull_family.h"

namespace hull::morphing {

// A member that has wanted numbers: the weights of its parents, and the factors by which it is
// scaled then. Its control points are those of the start with reached.moves.
struct WantedWeights {
  std::vector<double> weights;
  modelling::TargetsReached reached;
};

// The weights, and with options.scales length, beam and draft, with which a family meets targets at
// the least change from the member `start`: reach_targets() with the parents' differences from the
// first as modes. Weights may leave 0 to 1; folds are looked for. Limits and modes of the options
// do not count. Throws std::invalid_argument as HullFamily::points() and reach_targets() do, and
// where all parents are the same hull.
WantedWeights wanted_weights(const HullFamily& family, const std::vector<double>& start,
                             const std::vector<modelling::FormTarget>& targets,
                             modelling::TargetOptions options,
                             const surface::Progress& progress = {});

}  // namespace hull::morphing

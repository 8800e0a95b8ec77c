// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "modelling/fairing/fair_region.h"

namespace hull::modelling {

// The limits of the options, with all but the chosen points locked, and more held as the options
// ask. Throws std::invalid_argument for points that are none.
ReshapeLimits fair_limits(const surface::LimitSurface& surface, const FairOptions& options);

// Throws std::invalid_argument for bounds of FairRegion::solve() that are none.
void check_bounds(double deviation, double largest);

// Throws std::invalid_argument where a surface shifts farther than these bounds let: conditions
// come first, and with the shortest moves that meet them.
void refuse_farther(const Faired& faired, double deviation, double largest);

}  // namespace hull::modelling

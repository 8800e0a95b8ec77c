// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "modelling/fairing/fair_region.h"

namespace hull::modelling {

// The limits of the options, with all but the chosen points locked, and more held as the options
// ask. Throws std::invalid_argument for points that are none.
ReshapeLimits fair_limits(const surface::LimitSurface& surface, const FairOptions& options);

}  // namespace hull::modelling

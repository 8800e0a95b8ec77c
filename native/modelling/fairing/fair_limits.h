// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "modelling/fairing/fair_region.h"

namespace hull::modelling {

// The limits of the options, with all but the chosen points locked, and more held as the options
// ask. Throws std::invalid_argument for points that are none.
ReshapeLimits fair_limits(const surface::LimitSurface& surface, const FairOptions& options);

// A row for each condition, by (x, y, z) of each of the control points. Throws
// std::invalid_argument for conditions that are none.
Eigen::SparseMatrix<double> conditions_from(const std::vector<MoveCondition>& conditions,
                                            int point_count);

}  // namespace hull::modelling

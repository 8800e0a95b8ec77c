// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit.h"

namespace hull::modelling::fit_internal {

// Throws std::invalid_argument, naming it, for what fit() can't take.
void check_fit(const surface::LimitSurface& surface, const FitTarget& target,
               const std::vector<FitCurve>& curves, const FitOptions& options);

}  // namespace hull::modelling::fit_internal

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit.h"
#include "modelling/fit/fit_rows.h"
#include "surface/creases/crease_curves.h"

namespace hull::modelling::fit_internal {

// What points of curves want of the surface's creases and borders.
struct CurvePulls {
  std::vector<FitRow> rows;       // weights sum to 1 over the points that count
  std::vector<double> distances;  // of all curves' points, in order; NaN for those left out
  double mean_square = 0.0;
};

// Each point of a curve wants the chain's point nearest to it nearer, across the chain; ends of
// whole curves want the chain's ends.
CurvePulls find_curve_pulls(const surface::LimitSurface& surface,
                            const std::vector<FitCurve>& curves, const FitOptions& options);

}  // namespace hull::modelling::fit_internal

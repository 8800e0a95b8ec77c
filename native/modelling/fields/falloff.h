// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::modelling {

// The intensity of a field, at a distance delta from the base divided by the extent.
struct Intensity {
  double value;
  double rest;         // 1 - value, to rounding of itself
  double slope;        // by delta
  double kappa_slope;  // by kappa
};

// The selection function f of Veelo 2004, equation 3: from 1 at the base (delta = 0) down to 0 at
// the extent (delta = 1) and beyond. kappa, from 0 to 1, says how fast: f(1/2) is 1/8 at kappa = 0
// and 1/2 at 1.
//
// Twice continuously differentiable for 0 < kappa < 1. At kappa = 1 the second derivative jumps at
// the extent, so that curvature does; at kappa = 0 there is a cusp at the base, where the slope
// given is 0. The steepest slope is -3 / (1 + kappa), at delta = kappa / (1 + kappa).
//
// REQUIRES: delta >= 0, 0 <= kappa <= 1.
Intensity selection_intensity(double delta, double kappa);

}  // namespace hull::modelling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/falloff.h"

namespace hull::modelling {

Intensity selection_intensity(double delta, double kappa) {
  if (delta >= 1.0) return {0.0, 1.0, 0.0, 0.0};
  if (delta < kappa) {
    // By q = delta / kappa < 1 nothing is divided by kappa², which may be as small as can be.
    const double q = delta / kappa;
    const double rest = q * q * (3.0 * kappa - (1.0 + kappa) * delta);
    return {1.0 - rest, rest, 3.0 * q * ((1.0 + kappa) * q - 2.0),
            q * q * (3.0 - (2.0 + kappa) * q)};
  }
  // As a part of what is left between kappa and 1: no 0/0 however near these are.
  const double left = 1.0 - delta, part = left / (1.0 - kappa);
  const double value = left * left * part;
  // At kappa = 0: 1 - (1 - delta)³ without cancellation.
  const double rest = kappa == 0.0 ? delta * (3.0 - delta * (3.0 - delta)) : 1.0 - value;
  return {value, rest, delta == 0.0 ? 0.0 : -3.0 * left * part, left * part * part};
}

}  // namespace hull::modelling

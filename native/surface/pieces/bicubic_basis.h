// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "surface/pieces/bicubic.h"

namespace hull::surface {

// What the 16 B-spline points of a piece count for where the bases along its sides, or derivatives
// of them, have these values: point 4 b + a for along_t[b] · along_s[a].
inline Eigen::Matrix<double, 16, 1> bicubic_basis(const Basis& along_s, const Basis& along_t) {
  Eigen::Matrix<double, 16, 1> basis;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) basis[4 * b + a] = along_t[b] * along_s[a];
  }
  return basis;
}

}  // namespace hull::surface

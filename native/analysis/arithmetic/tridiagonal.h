// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/vectors.h"

namespace hull::analysis {

// The rows below[i] x[i-1] + diagonal[i] x[i] + above[i] x[i+1] = right[i], as cubic splines have
// them. REQUIRES: equal lengths, and a diagonal that dominates.
struct Tridiagonal {
  std::vector<double> below, diagonal, above;

  // Without below[0] and above[n-1].
  std::vector<Vector3d> solve(std::vector<Vector3d> right) const;
  // With them: x[-1] is x[n-1], and x[n] is x[0].
  std::vector<Vector3d> solve_cyclic(std::vector<Vector3d> right) const;
};

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/splines/quad_fit.h"

namespace hull::network {

struct ReferenceOptions {
  double tolerance;  // m, of the patch from points of curves
  int spans;         // the least number each way
};

struct ReferenceFit {
  FittedQuad quad;
  double error = 0.0;  // m: the furthest of the points from the patch
};

// The patch within four sides that passes near points of curves inside: of their squared distances
// and a little of ∫ S_uuu² + S_vvv² the least sum, under the constraints of fitted_quad(). The
// energy leaves biquadratic surfaces alone. Feet of the points are found anew after each solution;
// spans are doubled until the tolerance holds, up to 32. `start` is where feet are looked for
// first.
ReferenceFit fitted_to_curves(const std::array<QuadSide, 4>& sides, const QuadTarget& start,
                              const std::vector<Vector3d>& points, const ReferenceOptions& options);

}  // namespace hull::network

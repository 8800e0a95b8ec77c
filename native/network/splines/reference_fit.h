// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/splines/quad_fit.h"

namespace hull::network {

struct ReferenceOptions {
  double tolerance;  // m, of the patch from curves
  int spans;         // the least number each way
};

// A curve that a patch is to pass through, over 0 … 1: its points, and where in the patch's square
// they are to be.
struct Reference {
  std::function<Vector3d(double)> point;
  std::function<Eigen::Vector2d(double)> place;
};

struct ReferenceFit {
  FittedQuad quad;
  std::vector<double> errors;  // m, of each curve: the furthest of it from the patch

  double largest_error() const;
};

// The patch within four sides that passes through curves inside: of the squared distances of their
// points, several a span of the patch, from their places, and a little of ∫ S_uuu² + S_vvv², the
// least sum, under the constraints of fitted_quad(). The energy leaves biquadratic surfaces alone.
// Spans are doubled until the tolerance holds, between the points, too, up to 32. `start` is the
// patch where that has no solution.
ReferenceFit fitted_to_curves(const std::array<QuadSide, 4>& sides, const QuadTarget& start,
                              const std::vector<Reference>& curves,
                              const ReferenceOptions& options);

}  // namespace hull::network

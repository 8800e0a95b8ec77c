// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// A CreaseCurve by points on it.
struct FeatureCurve {
  surface::CreaseKind kind;
  std::vector<int> vertices;     // the chain's control vertices, in order; a closed chain's first
                                 // vertex is not repeated
  std::vector<Vector3d> points;  // points of the surface, m; a closed curve's first is repeated
  bool closed;
};

// All crease_curves(), with `samples_per_edge` intervals per edge of the control mesh (rounded up
// to an even number). Throws std::invalid_argument unless 1 <= samples_per_edge <= 1024.
std::vector<FeatureCurve> feature_curves(const surface::LimitSurface& surface,
                                         int samples_per_edge = 16);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull {

enum class FeatureKind { kCrease, kBorder };

// A chain of crease or border edges as a curve of the surface: a uniform cubic B-spline of the
// chain's control points, ending at corners, darts and where three or more creases meet.
struct FeatureCurve {
  FeatureKind kind;
  std::vector<int> vertices;     // the chain's control vertices, in order; a closed chain's first
                                 // vertex is not repeated
  std::vector<Vector3d> points;  // points of the surface, m; a closed curve's first is repeated
  bool closed;
};

// All of them, with `samples_per_edge` intervals per edge of the control mesh (rounded up to an
// even number). Chains of different kind do not join. Throws std::invalid_argument unless
// 1 <= samples_per_edge <= 1024.
std::vector<FeatureCurve> feature_curves(const LimitSurface& surface, int samples_per_edge = 16);

}  // namespace hull

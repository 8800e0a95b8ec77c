// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fit/fit.h"
#include "morphing/features/feature_matching.h"
#include "surface/limit_surface.h"

namespace hull::morphing {

// Places within a hull's box at the same place in another one's.
std::vector<Vector3d> in_box(const std::vector<Vector3d>& points, const HullBox& from,
                             const HullBox& to);

// A hull's control points brought near another hull: into its box, then the points of paired
// creases and borders to equal proportions of their counterparts' lengths (length_map()), and all
// others with them, by the least bending of the moves. Those of `held` stay in the centre plane.
std::vector<Vector3d> points_near(const surface::LimitSurface& surface, const FeatureGraph& graph,
                                  const FeatureGraph& other, const FeatureMatch& match,
                                  const std::vector<int>& held);

// For each chain of a paired feature the stretch of its counterpart that it is to lie along, for
// fit(); points no further apart than `spacing`, m.
std::vector<modelling::FitCurve> counterpart_curves(const FeatureGraph& graph,
                                                    const FeatureGraph& other,
                                                    const FeatureMatch& match, double spacing);

}  // namespace hull::morphing

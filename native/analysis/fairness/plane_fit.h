// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// The plane with the least sum of weighted squared distances, its normal's largest component
// positive, and how far the points spread within it.
struct PlaneFit {
  Plane plane;
  Vector3d along, across;  // unit vectors in it; the points spread most along the first
};

// REQUIRES: at least one point, as many weights, these positive.
PlaneFit fit_plane(const std::vector<Vector3d>& points, const std::vector<double>& weights);
PlaneFit fit_plane(const std::vector<Vector3d>& points);

}  // namespace hull::analysis

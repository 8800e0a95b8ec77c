// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "surface/eigenbasis/weight_row.h"
#include "surface/limit_surface.h"

namespace hull::surface {

// Points of a surface as sums of its control points: position(cell, u, v) = Σ weight · point. The
// weights are the basis functions of the generalized B-spline (Greshake 2021, 5.8) at that place;
// they depend on topology, tags and scheme only, and sum to 1. Exact everywhere, irregular points,
// creases and borders included: weights are off by about 1e-15.
//
// Refined points are remembered from query to query: a query costs microseconds where others were
// near before. Not for several threads at once.
class PointWeights {
 public:
  // `surface` must outlive it; set_points() on it changes nothing here.
  explicit PointWeights(const LimitSurface& surface) : surface_(surface) {}

  // By rising number of the point; no zeros. REQUIRES: as LimitSurface::position().
  std::vector<PointWeight> at(int cell, double u, double v);

  // The same of a refined point, as the layout numbers them.
  const WeightRow& refined(int point);

 private:
  const WeightRow& second(int half_edge);
  WeightRow leaf_row(int leaf, double u, double v);
  WeightRow corner_row(int corner, double u, double v);

  const LimitSurface& surface_;
  // Rows of refined points, and of any points of the second subdivision.
  std::unordered_map<int, WeightRow> refined_, second_;
};

}  // namespace hull::surface

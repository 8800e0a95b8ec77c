// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/pieces/point_weights.h"
#include "surface/surface_layout.h"

namespace hull::surface {

// The points that a square of the surface is made of, as sums of control points.
struct SquareWeights {
  std::vector<int> points;  // the control points that have a weight, rising
  Eigen::MatrixXd rows;     // a row for each point of the square, a column for each of `points`
};

// Of a regular cell: its 16 B-spline points, those beyond creases and borders included.
SquareWeights leaf_weights(const SurfaceLayout& layout, int leaf, PointWeights& weights);

// Of an irregular cell: the points that its CornerBasis takes.
SquareWeights corner_weights(const SurfaceLayout& layout, int corner, PointWeights& weights);

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/eigenbasis/corner_basis.h"
#include "surface/eigenbasis/corner_key.h"

namespace hull::surface {

// What running the subdivision rules on a model neighbourhood gives.
struct LocalMatrices {
  int ring_size;      // how many of the N points are ring_points()
  Eigen::MatrixXd A;  // N x N: the cell's control points to those of its child at the corner
  std::vector<RingSegment> segments;  // `dominant` still empty
};

LocalMatrices local_matrices(const CornerKey& key);

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "conversion/bspline_patch.h"

namespace hull {

// How far patches are from the surface they stand for, over samples that are not those the patches
// were fitted to and lie closer together.
//
// The distance of a sample is that between a point of the patch and the closest point found in the
// same cell of the surface, starting from the same (u, v): never more than the distance at equal
// (u, v), never less than that to the closest point of the whole surface, of which it is therefore
// an upper bound.
struct FitReport {
  double largest_distance = 0.0;  // metres, over all samples
  double rms_distance = 0.0;      // metres, root of the mean square over all samples
  int cell = -1;                  // where the largest distance is; -1: nothing was sampled
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  std::vector<double> cell_largest;  // metres, the largest distance of each patch
  int samples_per_cell = 0;
};

// Patches that join into a surface, and how: two sides with the same edge number are one curve, two
// corners with the same vertex number one point. Corner k of a patch is where its side k begins.
struct PatchSet {
  std::vector<BSplinePatch> patches;
  std::vector<std::array<int, 4>> corners;  // per patch, vertex numbers 0 ... vertex_count - 1
  std::vector<std::array<int, 4>> sides;    // per patch, edge numbers 0 ... edge_count - 1
  int vertex_count = 0;
  int edge_count = 0;
  FitReport report;

  // Diagonal of the box around all control points, m; 0 without any. What tolerances refer to.
  double size() const;

  // Throws std::invalid_argument naming the cell if a patch is malformed, a number is out of range,
  // an edge has more than two patches or two that run the same way along it, the two sides of an
  // edge differ (control points bit for bit, knots to rounding, either one reversed), or the
  // corners of one vertex do (bit for bit).
  void check() const;
};

}  // namespace hull

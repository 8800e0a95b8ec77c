// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/developable/ruled_row.h"

namespace hull::production {

struct RowLimits {
  double warp;              // rad/m: no ruling is to have more
  double distance;          // m: how far the creases may leave where they were
  std::vector<int> locked;  // control points that stay
  std::vector<std::pair<int, Vector3d>> held = {};  // those that move across a normal only
};

struct DevelopedRow {
  std::vector<Vector3d> points;  // all of the mesh's
  double before, after;          // no ruling has more warp, rad/m
  double distance;               // of the creases from where they were, m
  int iterations;
  bool reached;  // whether `after` is within the limit
};

// The largest warp of a row's rulings, by its bound; infinite where rulings have no length.
double warp_of(const RuledRow& row, const std::vector<Vector3d>& control);

// Moves the control points of a row's creases so that no ruling has more warp than the limit, first
// of all along the creases, so that these stay where they are; how far they leave that, is bounded,
// measured from each of 9 points of an edge to the old curve. By the method of Levenberg and
// Marquardt on the warp beyond the limit; ends of chains that are corners stay.
//
// Throws std::invalid_argument for limits that are not positive, points that are none, and where
// rulings have no length.
DevelopedRow developed_row(const surface::LimitSurface& surface, const RuledRow& row,
                           const std::vector<Vector3d>& control, const RowLimits& limits);

}  // namespace hull::production

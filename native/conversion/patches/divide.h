// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

// Where a patch is cut: parameters inside (0, 1), rising, those of its knots bit for bit.
struct PatchCuts {
  std::vector<double> u, v;
};

// The same surface as more patches: each cut into a grid of pieces. Edges are divided where the
// patches on either side are, so that pieces share them as whole patches did; pieces of one patch
// stand side by side, along u from row to row. Throws std::invalid_argument for pieces narrower
// than 2e-12 of their patch. REQUIRES: one PatchCuts per patch.
PatchSet divided(const PatchSet& set, const std::vector<PatchCuts>& cuts);

// Cuts at all knots: the pieces are Bézier patches, with 4 x 4 control points.
std::vector<PatchCuts> cuts_at_knots(const PatchSet& set);

// Bézier patches and those with no more than this are 4 x 4.
inline constexpr int kLeastControlPoints = 16;

// Cuts at knots, as few as leave no piece with more control points than `most`. Throws
// std::invalid_argument unless most >= kLeastControlPoints.
std::vector<PatchCuts> cuts_for_most_points(const PatchSet& set, int most);

}  // namespace hull::conversion

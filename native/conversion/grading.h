// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/exact_conversion.h"

namespace hull {

// How far a patch is off in a corner square, at samples that crowd towards the corner.
struct CornerError {
  double distance = 0.0;  // metres, to a near point of the cell
  double angle = 0.0;     // radians, between the normals there; on the two sides only
  double extent = 0.0;    // metres, of the square's diagonal
};

// Of the corner where side k of a patch begins. REQUIRES: the patch is that block's, `grading` its
// grading at this corner.
CornerError corner_error(const LimitSurface& surface, const Block& block, const BSplinePatch& patch,
                         int k, int grading);

// The patches of all blocks, with the least gradings that measurements find good enough.
std::vector<BSplinePatch> graded_patches(const LimitSurface& surface, const BlockLayout& layout,
                                         const ExactOptions& options);

}  // namespace hull

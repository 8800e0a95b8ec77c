// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/exact_patches.h"
#include "conversion/patch_set.h"

namespace hull {

inline constexpr int kUsualGrading = 8;

// A surface as few large patches, one for each block of BlockLayout: exact but for the squares of
// 2^-grading of a cell at irregular corners (see exact_patch()).
//
//   - Corners of patches are the surface's points, each computed once and shared bit for bit.
//   - A side is divided where neighbours have corners within it. What two patches share is one
//     curve: a part of the one's and of the other's border, equal to kLargestGap of the size.
//   - A patch's cell is the one at its corner (0, 0).
PatchSet exact_patches(const LimitSurface& surface, int grading = kUsualGrading);

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/exact_patches.h"
#include "conversion/patch_set.h"
#include "conversion/progress.h"

namespace hull {

struct ExactOptions {
  // Of the largest extent of the mesh: how far the patches may be from the surface.
  double tolerance = 1e-6;
  // Radians: how much the normals of two patches may differ at an edge that is no crease. 0: what
  // goes well with the tolerance, 0.02 degrees at 1e-6 and in proportion to its square root.
  double seam_angle = 0.0;
  // How often knots are halved at irregular corners, 0: as often as the two above need.
  int grading = 0;
};

// A surface as few large patches, one for each block of BlockLayout: exact but for the squares of
// 2^-grading of a cell at irregular corners (see exact_patch()).
//
//   - Corners of patches are the surface's points, each computed once and shared bit for bit.
//   - A side is divided where neighbours have corners within it. What two patches share is one
//     curve: a part of the one's and of the other's border, equal to kLargestGap of the size.
//   - A patch's cell is the one at its corner (0, 0).
//   - Gradings are the least that measurements in the corner squares find good enough; the same for
//     irregular points that are joined by sides of blocks. They go no further than 16, and where a
//     corner square is smaller than the tolerance its normals do not count.
//
// Throws std::invalid_argument unless the tolerance is from 1e-10 to 0.1, the angle 0 to 1, and the
// grading 0 or one of exact_patch().
PatchSet exact_patches(const LimitSurface& surface, const ExactOptions& options = {},
                       const Progress& progress = {});

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/exact/exact_patches.h"
#include "conversion/patches/patch_set.h"
#include "surface/progress.h"

namespace hull::conversion {

struct ExactOptions {
  // Of the largest extent of the mesh: how far the patches may be from the surface.
  double tolerance = 1e-6;
  // Radians: how much the normals of two patches may differ at an edge that is no crease. 0: what
  // goes well with the tolerance, 0.02 degrees at 1e-6 and in proportion to its square root.
  double seam_angle = 0.0;
  // How often knots are halved at irregular corners, 0: as often as the two above need.
  int grading = 0;
  // Knots are inserted until neighbours have the same ones along the edges they share.
  bool matched_knots = false;
  // A patch with more control points is cut into several, at knots; 0: none is.
  int most_control_points = 0;
  // Patches are cut at all knots, into Bézier patches; the two above are nothing then.
  bool bezier = false;
};

// A surface as few large patches, one for each block of BlockLayout: exact but for the squares of
// 2^-grading of a cell at irregular corners (see exact_patch()).
//
//   - Corners of patches are the surface's points, each computed once and shared bit for bit.
//   - A side is divided where neighbours have corners within it. What two patches share is one
//     curve: a part of the one's and of the other's border, equal to kLargestGap of the size.
//   - A patch's cell is the one at its corner (0, 0).
//   - Gradings are as small as measurements in the corner squares allow; the same for irregular
//     points that are joined by sides of blocks. They end where knots would come closer than CAD
//     systems tell apart. Normals nearer to irregular points than the tolerance do not count.
//   - Patches cut further stand for parts of their blocks.
//   - A border along the centre plane lies in it exactly (centre_line.h).
//
// Throws std::invalid_argument unless the tolerance is from 1e-10 to 0.1, the angle 0 to 1, the
// grading 0 or one of exact_patch(), and the most control points 0 or at least 16.
PatchSet exact_patches(const surface::LimitSurface& surface, const ExactOptions& options = {},
                       const surface::Progress& progress = {});

}  // namespace hull::conversion

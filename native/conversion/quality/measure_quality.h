// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "conversion/patches/patch_set.h"
#include "conversion/quality/quality_report.h"
#include "surface/limit_surface.h"
#include "surface/progress.h"

namespace hull::conversion {

struct QualityOptions {
  // In each interval between knots, and in each direction; 1 to 16.
  int samples = 3;
  // m, around irregular points: normals within are told apart from the others, because no CAD
  // system sees them. Unless given, 1e-6 of the length.
  std::optional<double> normal_reach = {};
};

// Measures patches against the surface that they stand for (PatchSet::blocks), at samples that have
// nothing to do with how the patches were made:
//
//   - Intervals are those between the patch's knots and the borders of cells. At irregular points
//     the last one is halved some times more, so that samples crowd there geometrically. Each takes
//     `samples` Gauss nodes in each direction, and the patch's sides as many more.
//   - A distance is that from a point of the patch to the nearest point of the surface that a
//     descent from its own place finds, also beyond the borders of cells: an upper bound of the
//     distance to the surface, and in general equal to it. The largest of a patch is to the
//     nearest of all points of the surface, and may be 1e-3 of it too small.
//   - Areas and root mean squares are integrals over the patches.
//   - Seams are sampled in the intervals of both sides' knots, halved towards irregular points.
//     Gaps are from points of one curve to near points of the other. Curvature is that of the
//     normal section at right angles to the seam: it is what a jump of second derivatives changes.
//     Where a patch has no normal (sides of no length) angles and curvatures are left out.
//
// Patches without cells have no distance, and their seams gaps only.
//
// Throws std::invalid_argument unless the set has a block for each patch, with cells of this
// surface and made of its control points, and the options are in range. REQUIRES: set.check() does
// not throw.
QualityReport measure_quality(const surface::LimitSurface& surface, const PatchSet& set,
                              const QualityOptions& options = {},
                              const surface::Progress& progress = {});

}  // namespace hull::conversion

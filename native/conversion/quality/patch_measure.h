// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/arithmetic/gauss.h"
#include "conversion/blocks/ringed_surface.h"
#include "conversion/patches/patch_set.h"
#include "conversion/quality/quality_report.h"
#include "surface/progress.h"
#include "surface/queries/surface_tree.h"

namespace hull::conversion {

// What patches and seams are measured with.
struct QualityGauge {
  const surface::LimitSurface& surface;
  const RingedSurface& ringed;       // the same
  const surface::SurfaceTree& tree;  // of the surface
  const PatchSet& set;
  analysis::GaussRule rule;
  double length = 0.0;          // m
  double reach = 0.0;           // m, around irregular points
  std::vector<char> irregular;  // per vertex of the cells

  // Below this a distance is rounding, m: no nearer point is looked for.
  double negligible() const { return 1e-13 * length; }
};

// The vertices of the cells where the surface is only C¹, seen from any cell.
std::vector<char> irregular_vertices(const surface::LimitSurface& surface);

// Distances of one patch. rms_distance is the root of the mean, over its area, of squares.
PatchQuality measure_patch(const QualityGauge& gauge, int patch, const surface::Progress& progress);

}  // namespace hull::conversion

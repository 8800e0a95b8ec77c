// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "conversion/quality/patch_measure.h"

namespace hull::conversion {

struct SeamSide {
  int patch = -1, side = -1;
  SideEdge part;
};

// The two uses of an edge.
using Seam = std::array<SeamSide, 2>;

std::vector<Seam> seams_of(const PatchSet& set);

SeamQuality measure_seam(const QualityGauge& gauge, const Seam& seam);

}  // namespace hull::conversion

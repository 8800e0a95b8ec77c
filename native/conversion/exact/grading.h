// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/exact/exact_conversion.h"
#include "surface/progress.h"

namespace hull::conversion {

// The patches of all blocks, graded as `options` ask, their corner squares fitted to one another.
std::vector<BSplinePatch> graded_patches(const surface::LimitSurface& surface,
                                         const BlockLayout& layout, const ExactOptions& options,
                                         const surface::Progress& progress);

}  // namespace hull::conversion

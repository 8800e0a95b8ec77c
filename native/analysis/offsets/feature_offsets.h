// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/offsets/offset_table.h"

namespace hull::analysis {

// The features of offset_table(), at stations that are finite.
std::vector<FeatureOffsets> feature_offsets(const surface::LimitSurface& surface,
                                            const std::vector<double>& stations);

}  // namespace hull::analysis

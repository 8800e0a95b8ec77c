// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/hydrostatics/hydrostatics.h"

namespace hull::analysis {

// Throws std::invalid_argument if a number is not finite, trim is 90° or more, a dimension is
// negative or the density is not positive.
void check_hydrostatics(const FloatingPosition& position, const ProjectDimensions& project,
                        double water_density);

}  // namespace hull::analysis

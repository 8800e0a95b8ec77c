// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stations/station_cutter.h"

namespace hull::analysis {

// The station of the largest immersed area, the one nearest to the middle of the immersed length
// among equals. Nine stations tell where to look: a maximum narrower than an eighth of the length
// may be missed. Its area is exact to about 1e-8 of itself.
SectionArea largest_section(const StationCutter& cutter, const Plane& water);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stations/kept_stations.h"

namespace hull::analysis {

// The station of the largest immersed area, the one nearest to the middle of the immersed length
// among equals. Nine stations tell where to look: a maximum narrower than an eighth of the length
// may be missed. Its area is exact to about 1e-8 of itself.
//
// With stations that are kept of the body, those are taken that have not moved; the result is the
// same to the last bit.
SectionArea largest_section(const StationCutter& cutter, const Plane& water,
                            KeptStations* kept = nullptr);

}  // namespace hull::analysis

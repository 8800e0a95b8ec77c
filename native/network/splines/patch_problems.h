// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "network/joining/network_problem.h"
#include "network/patches/region_sides.h"

namespace hull::network {

// A region that has no patches, and why.
NetworkProblem open_region(const NetworkFrame& frame, const std::vector<RegionSide>& sides,
                           const std::string& reason);

// A region whose patches have not everywhere the tangent planes that its curves tell.
NetworkProblem loose_region(const NetworkFrame& frame, const std::vector<RegionSide>& sides);

// A curve that splines of the most spans are off by more than their tolerance: by `error`, m.
NetworkProblem missed_curve(const std::string& name, int curve, const Vector3d& place,
                            double error);

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "network/joining/joined_curves.h"

namespace hull::network {

// Leaves what bounds regions: edges that end where no other edge is go, one after the other, and
// so do those apart from the part with the most edges. Each is named among the problems. Nodes
// without edges go, and others are numbered anew; visits are those of nodes that stay.
void keep_connected(JoinedCurves& joined, const std::vector<CurveShape>& shapes,
                    const std::vector<std::string>& names);

}  // namespace hull::network

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/splines/side_spline.h"

namespace hull::network {

// m, of each edge: how far the curve as it is given, of which the edge is a part, is from the
// edge's spline at most. What brings the curve to its nodes counts, too.
std::vector<double> edge_errors(const NetworkFrame& frame, const EdgeSplines& splines);

}  // namespace hull::network

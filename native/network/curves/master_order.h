// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/curves/network_curve.h"

namespace hull::network {

// The numbers of curves, each after its masters. Throws std::invalid_argument that names the curves
// of a circle, in order, or a curve whose master is not there.
std::vector<int> masters_first(const std::vector<CurveDefinition>& definitions);

}  // namespace hull::network

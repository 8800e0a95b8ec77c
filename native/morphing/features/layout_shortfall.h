// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "morphing/features/layout_fit.h"

namespace hull::morphing {

// Why a layout lies farther from the second hull than `tolerance`, of that hull's length, or why
// members between the two are folded, and what to do: the lines near there that have no counterpart
// are named. Empty where neither is so. The graphs are of the hulls as they were given.
std::string layout_shortfall(const FeatureGraph& first, const FeatureGraph& second,
                             const LayoutFit& fit, double tolerance);

}  // namespace hull::morphing

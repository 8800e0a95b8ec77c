// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/patches/ribboned_side.h"

namespace hull::network {

// A point of the patch of four sides, over the unit square (see TransfinitePatch).
PatchPoint coons_gregory(const std::vector<RibbonedSide>& sides, const Vector2d& place);

}  // namespace hull::network

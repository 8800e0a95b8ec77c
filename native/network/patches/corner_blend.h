// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/patches/ribboned_side.h"

namespace hull::network {

// A point of the patch of three or five and more sides, over a regular polygon (see
// TransfinitePatch).
PatchPoint corner_blend(const std::vector<RibbonedSide>& sides,
                        const std::vector<Vector2d>& polygon, const Vector2d& place);

}  // namespace hull::network

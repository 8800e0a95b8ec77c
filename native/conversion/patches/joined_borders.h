// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

// Where two patches share an edge that is a whole side of each, with the same knots, the second
// takes the first one's control points along it: they are the same but for rounding, and bit for
// bit afterwards. REQUIRES: set.check() does not throw.
void join_borders(PatchSet& set);

}  // namespace hull::conversion

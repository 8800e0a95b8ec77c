// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/segments/segments.h"

namespace hull::production {

// Drills holes for dowels into both sides of each joint of the segments, whose boxes tell what they
// have in common.
void add_dowel_holes(ModelSegments& segments, const Dowels& dowels);

}  // namespace hull::production

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// The least and the greatest height of the control points, both sides, along a direction: no part
// of the body is outside.
struct HeightRange {
  double low, high;
};
HeightRange height_range(const HullBody& body, const Vector3d& direction);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/hull_heights.h"

namespace hull::analysis {

// Volume of the body when it is wholly under water, m³.
double greatest_volume(const HullBody& body, const Vector3d& up);

// The offset of the water with the normal `up` in which the body displaces the volume, to an error
// of `tolerance` of it or of what is above water, if that is less. REQUIRES: 0 < volume <
// whole_volume, which is greatest_volume(). Adds to `evaluations` the immersions computed.
double offset_of_volume(const HullBody& body, const Vector3d& up, double volume,
                        double whole_volume, double tolerance, int& evaluations);

}  // namespace hull::analysis

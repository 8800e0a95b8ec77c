// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/vectors.h"

namespace hull::mesh {

// "(1.00, 2.00, 3.00)" with a number of decimals, for sentences; without "-0.00". REQUIRES: 0 to 9
// decimals.
std::string place_text(const Vector3d& place, int decimals);

}  // namespace hull::mesh

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/shell_plates.h"

namespace hull::production {

// Whether a point of the surface lies in the centre plane, to rounding.
bool is_central(const surface::LimitSurface& surface, const Vector3d& point);

// Makes a plate of half a hull one with its mirror image, if PlatingOptions::across_centre says so
// of it. One that touches the centre plane in several places stays as it is.
void join_across_centre(const PlatedShell& shell, double largest_knuckle, Plate& plate);

}  // namespace hull::production

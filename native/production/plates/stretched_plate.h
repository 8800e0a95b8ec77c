// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/flat_plate.h"

namespace hull::production {

// Lays a plate that is not developable out by the least energy: all of `flat` but for its axis and
// its bend, before it is turned along x. Its mesh is there. Throws as flat_plate().
void stretch(FlatPlate& flat, const Plate& plate, double poisson);

}  // namespace hull::production

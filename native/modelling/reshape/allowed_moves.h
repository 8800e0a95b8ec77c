// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/move_space.h"

namespace hull::modelling {

// Of these points the moves within a space that are nearest to those told, in least squares,
// whatever other points have to do for it: as prescribed points of the same limits they are never
// refused. Throws std::invalid_argument for points that are none, and without a finite move for
// each.
std::vector<Vector3d> allowed_moves(const MoveSpace& space, const std::vector<int>& points,
                                    const std::vector<Vector3d>& moves);

}  // namespace hull::modelling

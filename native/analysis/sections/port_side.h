// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "surface/limit_surface.h"

namespace hull::analysis {

// Why a surface has no port side to measure, as a sentence; empty where it has.
//
// mirrored: it is to stand for the port half of a hull. It can't where its control points reach
// less than half as far to port as to starboard: then it is the other half, whose centre line may
// lie across the centre plane. Of a whole hull, of any shape, only noise must not be all there is.
std::string missing_port_side(const surface::LimitSurface& surface, bool mirrored);

}  // namespace hull::analysis

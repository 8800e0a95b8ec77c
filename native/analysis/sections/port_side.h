// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "surface/limit_surface.h"

namespace hull::analysis {

// Why a surface can't stand for the port half of a hull, as a sentence; empty where it can: its
// control points are to starboard, but for some noise at the centre plane.
std::string missing_port_side(const surface::LimitSurface& surface);

}  // namespace hull::analysis

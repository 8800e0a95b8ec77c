// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/caps/cap_maker.h"

namespace hull::conversion {

// Adds plane faces within edges that lie in the centre plane y = 0, each given in the direction in
// which a face has to run along it; a face has as holes the loops within its own. Their outside is
// that of the side on which they run counter-clockwise.
//
// Throws std::invalid_argument where the edges do not make closed loops.
void close_centre_plane(CapMaker& maker, const EdgePath& edges, bool is_port_half);

}  // namespace hull::conversion

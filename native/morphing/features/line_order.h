// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "morphing/features/hull_box.h"
#include "surface/creases/crease_curves.h"

namespace hull::morphing {

// A chain as a step of a line: its number, and whether it is run through backwards.
struct Link {
  int chain;
  bool is_backward;
};

// Turns a line round so that it runs as features do: an open one forward, upwards or outwards,
// whichever is most. A closed one begins at the end of a chain, or of a closed chain at the control
// point, that is furthest aft, low and to starboard, in a slanting direction, around which it
// runs; so lines of one shape have one order, whatever numbers they have. Returns
// the number among its chain's vertices with which a closed chain begins, else 0.
int set_order(const std::vector<surface::CreaseCurve>& curves, const HullBox& hull,
              std::vector<Link>& line);

}  // namespace hull::morphing

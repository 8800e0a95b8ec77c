// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

// The same patches with knots inserted until the two curves of every edge have the same ones: for
// systems that join faces only where their borders agree in that. Knots run through patches, so
// that they spread to all patches side by side.
//
// REQUIRES: inner knots are simple, or as often there on both sides of an edge.
void match_knots(PatchSet& set);

}  // namespace hull::conversion

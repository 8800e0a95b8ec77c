// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

struct WithoutFlatPatches {
  PatchSet patches;           // numbers of vertices and edges as before; some may be unused
  std::vector<int> left_out;  // cells
  std::vector<bool> is_kept;  // of every patch given
};

// Leaves out patches that have no area because they are folded onto a line or a point: they have no
// normal, no program takes them for a face, and nothing of the surface is lost with them. Flat is
// what is nowhere wider than kNoLength of the set's size.
//
// Where exactly two sides of such a patch have a length and lie on one another, the patches beyond
// them are joined: the control points of the one take the place of the other's (so little
// away). Other sides of it become borders, which lie on one line.
//
// REQUIRES: set.check() does not throw.
WithoutFlatPatches without_flat_patches(const PatchSet& set);

}  // namespace hull::conversion

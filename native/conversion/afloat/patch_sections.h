// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/sections.h"
#include "conversion/afloat/patch_pieces.h"

namespace hull::conversion {

// The sections of a set of patches by several planes, in their order, as analysis::sections() gives
// those of a limit surface; `cells` are patches, and `uv` places on them. Points are on patch and
// plane to 1e-10 of the set's size. What lies in the plane: of flat pieces the border; sides of
// pieces between knots, each as a whole. Knuckles are where the section turns by more than 0.6°:
// seams of patches that stand for a smooth surface turn by hundredths of a degree.
//
// Throws std::invalid_argument as analysis::sections() does.
std::vector<std::vector<analysis::SectionCurve>> patch_sections(
    const PatchPieces& pieces, const std::vector<analysis::Plane>& planes,
    const analysis::SectionOptions& options);

}  // namespace hull::conversion

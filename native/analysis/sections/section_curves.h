// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/section_point.h"
#include "analysis/sections/sections.h"

namespace hull::analysis {

// The parts of a section joined to curves.
std::vector<SectionCurve> section_curves(const surface::LimitSurface& surface,
                                         const SectionParts& parts);

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "analysis/sections/section_point.h"
#include "analysis/sections/sections.h"

namespace hull::analysis {

// The parts of a section joined to curves.
std::vector<SectionCurve> section_curves(const surface::LimitSurface& surface,
                                         const SectionParts& parts);

// What joining asks of a shell, whatever that is made of: places are as SectionPoint has them.
struct SectionShell {
  using IsThere = std::function<bool(int cell, const Eigen::Vector2d& uv)>;
  double size;  // m
  double turn;  // rad: tangents that turn by more make a knuckle
  IsThere is_crease, is_border;
};
std::vector<SectionCurve> section_curves(const SectionShell& shell, const SectionParts& parts);

}  // namespace hull::analysis

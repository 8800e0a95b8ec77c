// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analysis/immersion/cut_moments.h"

namespace hull::analysis {

// Moments of the part of a span below all of one or two planes, as wet_moments() has them of one:
// where both cut it, it is quartered until they do so in different squares. In the last squares, of
// 2^-12 of the span, both are taken for planes across the square.
ShellMoments wedge_moments(const surface::BicubicPoints& points, const Vector3d& origin,
                           std::span<const Plane> planes, const CutRules& rules);

}  // namespace hull::analysis

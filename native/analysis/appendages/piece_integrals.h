// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analysis/appendages/closed_shell.h"
#include "analysis/immersion/shell_moments.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// Thrown where lines of a piece run along another surface, not across it, or come so near to others
// so often that there is no end to it.
struct SurfacesInOneAnother {};

struct PieceRule {
  Vector3d origin;      // moments are about it
  double volume, area;  // errors of an interval, m³ and m²
  // Of lines, looked at where they cross surfaces, all pieces together; null without a limit.
  PartsLeft* parts_left = nullptr;
};

// Of a whole patch; the area, which is no polynomial, by halves until it is that near.
ShellMoments whole_patch_moments(const surface::BezierPatch& patch, const PieceRule& rule);

// Of the part of a patch below the water, if there is one, whose points are taken: `takes` is asked
// with what holds for each of the surfaces, whether a point is inside of it.
using Takes = std::function<bool(const std::vector<bool>&)>;
ShellMoments cut_patch_moments(const surface::BezierPatch& patch,
                               const std::vector<const ClosedShell*>& surfaces, const Takes& takes,
                               const Plane* water, const PieceRule& rule);

}  // namespace hull::analysis

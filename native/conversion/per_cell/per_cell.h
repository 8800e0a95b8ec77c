// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/patch_set.h"
#include "surface/limit_surface.h"

namespace hull::conversion {

constexpr int kMinControlPoints = 4, kMaxControlPoints = 16;

// One bicubic B-spline patch per cell of the surface, by the three-step least-squares fit of
// Greshake 2021, section 7.2: open-uniform knots, control_points x control_points per patch, data
// on a uniform grid of the cell. Patch number c stands for cell c and has the cell's (u, v).
//
//   - Corners lie on the surface. Each is computed once per vertex and shared bit for bit.
//   - Each border curve is fitted once per edge and shared bit for bit: the patches have no gaps.
//   - A cell that is bicubic is reproduced to rounding; others are approximated (measure_quality()
//     says how closely). 5 control points are a good trade (section 7.3), more come closer.
//   - A cell with borders of no length (points that coincide) gets a patch like any other.
//
// Throws std::invalid_argument unless kMinControlPoints <= control_points <= kMaxControlPoints.
PatchSet fit_per_cell(const surface::LimitSurface& surface, int control_points = 5);

}  // namespace hull::conversion

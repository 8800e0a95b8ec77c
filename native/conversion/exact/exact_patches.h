// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/blocks/block_spans.h"
#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {

// How often the knots around an irregular corner are halved.
inline constexpr int kLeastGrading = 2, kMostGrading = 30;

// The surface over one block as a bicubic B-spline with simple knots, at the lines between its
// spans and, around every irregular corner, at the borders of `grading` rings of spans, which halve
// from ring to ring. It equals the surface to rounding but for the squares of 2^-grading of a cell
// at these corners, and at the corners' points.
//
// Lines between cells of one face of the control mesh are no knots where the surface is one
// polynomial across them. The patch's (u, v) in [0, 1]² are the block's.
//
// The lines of knots run through the whole patch: where two corners at the ends of a side are
// irregular, their gradings must be the same.
//
// Throws std::invalid_argument unless kLeastGrading <= grading <= kMostGrading.
BSplinePatch exact_patch(const surface::LimitSurface& surface, const Block& block, int grading);
BSplinePatch exact_patch(const surface::LimitSurface& surface, const Block& block,
                         const Gradings& gradings);

}  // namespace hull::conversion

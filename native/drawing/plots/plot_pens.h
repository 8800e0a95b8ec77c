// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of a plot look like.
#pragma once

#include "drawing/paper/pens.h"
#include "drawing/plots/plot.h"

namespace hull::drawing {

namespace pens {
inline constexpr Pen kFineGrid{0.06, {0.86, 0.86, 0.86}};
inline constexpr Pen kPlotGrid{0.12, {0.70, 0.70, 0.70}};
inline constexpr Pen kPlotFrame{0.25, inks::kBlack};
inline constexpr Pen kZero{0.22, {0.25, 0.25, 0.25}};
inline constexpr Pen kReference{0.22, {0.30, 0.30, 0.30}, {2.4, 0.9, 0.5, 0.9}};
}  // namespace pens

// Dark enough on white paper, and apart in brightness as well as in hue.
Ink palette_colour(int number);

Ink colour_of(const Plot& plot, int curve);

// The pen of a curve.
Pen pen_of(const Plot& plot, int curve);

// Of the area with this number among the areas of a plot: pale, so that the grid shows through.
Ink area_colour(int number);

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace hull::analysis {

// Red, green and blue of sRGB, each in [0, 1], as screens take them.
using Colour = std::array<double, 3>;

// For numbers below and above zero, which is at t = 0.5: blue over white to orange, which people
// with any of the common colour blindnesses tell apart. Lightness falls evenly to both sides; built
// in the polar form of CIELAB (Moreland 2009, "Diverging Color Maps for Scientific Visualization").
// t is clamped to [0, 1].
Colour diverging_colour(double t);

// For numbers from least to most: from dark to light, so that it can be read as shades of grey,
// too. A helix about the axis of greys (Green 2011, "A colour scheme for the display of
// astronomical intensity images").
Colour sequential_colour(double t);

// Neither: for places without a value.
inline constexpr Colour kNoValueColour{0.55, 0.55, 0.55};

}  // namespace hull::analysis

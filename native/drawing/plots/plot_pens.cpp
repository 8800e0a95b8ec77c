// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_pens.h"

#include <array>
#include <cstddef>
#include <stdexcept>

namespace hull::drawing {

namespace {

constexpr std::array<Ink, 8> kPalette{{{0.05, 0.25, 0.60},
                                       {0.75, 0.12, 0.10},
                                       {0.02, 0.45, 0.25},
                                       {0.55, 0.10, 0.55},
                                       {0.80, 0.42, 0.00},
                                       {0.00, 0.48, 0.60},
                                       {0.40, 0.26, 0.13},
                                       {0.20, 0.20, 0.20}}};

constexpr std::array<Ink, 3> kAreas{
    {{0.25, 0.50, 0.85, 0.25}, {0.90, 0.60, 0.10, 0.25}, {0.15, 0.65, 0.40, 0.25}}};

constexpr double kCurveWidth = 0.38;
constexpr double kGuideWidth = 0.22;

Dashes dashes_of(LineStyle style) {
  switch (style) {
    case LineStyle::kSolid:
      return {};
    case LineStyle::kDashed:
      return {2.4, 1.0, 2.4, 1.0};
    case LineStyle::kDotted:
      return {0.5, 0.8, 0.5, 0.8};
    case LineStyle::kChain:
      return {3.6, 0.9, 0.6, 0.9};
  }
  throw std::logic_error("a style of lines without dashes");
}

}  // namespace

Ink palette_colour(int number) {
  return kPalette[static_cast<std::size_t>(number) % kPalette.size()];
}

Ink colour_of(const Plot& plot, int curve) {
  return plot.curves[curve].colour.value_or(palette_colour(curve));
}

Pen pen_of(const Plot& plot, int curve) {
  const PlotCurve& drawn = plot.curves[curve];
  return {drawn.guide ? kGuideWidth : kCurveWidth, colour_of(plot, curve), dashes_of(drawn.style)};
}

Ink area_colour(int number) { return kAreas[static_cast<std::size_t>(number) % kAreas.size()]; }

}  // namespace hull::drawing

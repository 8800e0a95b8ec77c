// SPDX-License-Identifier: GPL-3.0-or-later
// Dots, reference lines and texts among the curves of a plot, each where it hides nothing.
#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "drawing/plots/plot_frame.h"

namespace hull::drawing {

// A round dot of 0.8 mm radius.
PagePath dot_outline(const Eigen::Vector2d& centre);

// A curve on the page, with the numbers of its paths as obstacles for texts.
struct PlottedCurve {
  int curve;
  std::vector<PagePath> paths;
  std::vector<int> numbers;
};

// What got no text beside it and must be explained in the legend.
struct Unlabelled {
  std::set<int> markers, lines;

  bool operator==(const Unlabelled&) const = default;
};

// Draws the lines and dots inside the frame, and their texts where there is room. No text is tried
// for those in `in_legend`. Returns what got none, `in_legend` included.
Unlabelled draw_marks(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame,
                      const Unlabelled& in_legend);

// Sets each curve's symbol on or beside it, where there is room.
void draw_symbols(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame,
                  const std::vector<PlottedCurve>& curves);

}  // namespace hull::drawing

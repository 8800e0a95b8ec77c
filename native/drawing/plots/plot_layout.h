// SPDX-License-Identifier: GPL-3.0-or-later
// A plot with everything in its place, for paper and screen alike.
//
// From top to bottom: title, subtitles, the diagram with its grid, the numbers and names of its
// axes, the legend. Several x axes stand below one another as rulers, each beside the names of its
// curves; where the page is too small for them, the grid's divisions are numbered and the legend
// says what a division is of each curve.
#pragma once

#include <string>

#include "drawing/paper/paper.h"
#include "drawing/paper/sheet.h"
#include "drawing/plots/plot.h"
#include "drawing/plots/plot_frame.h"

namespace hull::drawing {

struct PlotPage {
  double width, height;  // mm
  double margin;         // kept free on all sides, mm
};

struct PlotSheet : Sheet {
  PlotFrame frame;
};

inline constexpr double kLeastPlotSide = 40.0;  // mm, of the page without its margin

// No two texts overlap, none crosses a curve, all is inside the page without its margin. Texts
// longer than their room are made smaller or end in an ellipsis.
//
// Throws std::invalid_argument as check_plot (plot.h), and when a side of the page without its
// margin is below kLeastPlotSide or above 5 m.
PlotSheet lay_out_plot(const Plot& plot, const PlotPage& page);

// Lays out on landscape paper with a margin of 12 mm, and writes. Throws as lay_out_plot and
// write_sheet (canvas.h).
void write_plot(const Plot& plot, const std::string& path, Paper paper = Paper::kA4);

}  // namespace hull::drawing

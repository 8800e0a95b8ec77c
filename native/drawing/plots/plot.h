// SPDX-License-Identifier: GPL-3.0-or-later
// A diagram of curves over axes, as a person reads it: what is to be drawn, in the units of its
// axes. plot_layout.h decides where everything goes.
//
// All curves share the y axis. With one x axis this is the usual diagram. With several, every
// curve has the scale of its x axis and all scales share one grid: the hydrostatic curves of a ship
// over its draft.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/paper/sheet.h"

namespace hull::drawing {

struct PlotRange {
  double low, high;

  bool operator==(const PlotRange&) const = default;
};

struct PlotAxis {
  std::string label;               // "Heel"
  std::string unit;                // "°", "m³"; may be empty
  std::optional<PlotRange> range;  // what is shown; default: the curves, rounded outwards
  bool from_zero = false;          // zero is shown, whatever the curves

  bool operator==(const PlotAxis&) const = default;
};

enum class LineStyle { kSolid, kDashed, kDotted, kChain };

// A number that is not finite interrupts the curve there. A point without neighbours is drawn as a
// dot.
struct PlotCurve {
  std::string name;    // for the legend; without one the curve is not in it
  std::string symbol;  // short, set on the curve itself; may be empty
  std::vector<double> x, y;
  int x_axis = 0;
  std::optional<Ink> colour;  // default: the next of the palette (plot_pens.h)
  LineStyle style = LineStyle::kSolid;
  bool guide = false;  // thin, and the axes are not widened for its sake

  bool operator==(const PlotCurve&) const = default;
};

// A dot with a text beside it, in the scale and colour of a curve; black on the first axis for
// curve -1.
struct PlotMarker {
  double x, y;
  std::string label;
  int curve = -1;

  bool operator==(const PlotMarker&) const = default;
};

// A line across the whole diagram; a vertical one stands on the first x axis.
struct PlotLine {
  double at;
  bool vertical;
  std::string label;

  bool operator==(const PlotLine&) const = default;
};

// What is between a curve and y = 0, from one x to another; explained in the legend.
struct PlotArea {
  int curve;
  double from, to;
  std::string label;

  bool operator==(const PlotArea&) const = default;
};

// A bar in the legend that shows what a length along the first x axis stands for.
struct PlotBar {
  double length;
  std::string label;

  bool operator==(const PlotBar&) const = default;
};

struct Plot {
  std::string title;
  std::vector<std::string> subtitles;
  std::vector<PlotAxis> x_axes;  // one at least
  PlotAxis y_axis;
  std::vector<PlotCurve> curves;
  std::vector<PlotMarker> markers;
  std::vector<PlotLine> lines;
  std::vector<PlotArea> areas;
  std::vector<PlotBar> bars;

  bool operator==(const Plot&) const = default;
};

// Throws std::invalid_argument, naming the part: when there is no x axis; a range is not finite or
// not rising; x and y of a curve differ in length; a number is beyond ±1e100; a marker, line, area
// or bar is not finite; or one refers to a curve or an axis that is not there. A plot without
// curves, and curves without points, are well.
void check_plot(const Plot& plot);

}  // namespace hull::drawing

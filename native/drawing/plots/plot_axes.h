// SPDX-License-Identifier: GPL-3.0-or-later
// The scales of a plot's axes, and their numbers and names on the page.
#pragma once

#include <string>
#include <vector>

#include "drawing/plots/plot_frame.h"
#include "drawing/plots/plot_legend.h"

namespace hull::drawing {

// How several x axes are shown; one alone is always under the diagram.
enum class AxesKind { kSingle, kRulers, kDivisions };

inline constexpr double kNumberSize = 2.4;  // mm, font of the numbers
inline constexpr double kNumberRow = 4.4;
inline constexpr double kAxisNameRow = 4.4;
inline constexpr double kRulerRow = 5.4;

AxisScale y_scale(const Plot& plot, double height);
std::vector<AxisScale> x_scales(const Plot& plot, double width);

// The width of the widest of the numbers along an axis.
double number_width(const AxisScale& scale);

// "Heel [°]".
std::string axis_text(const PlotAxis& axis, const AxisScale& scale);

// What stands at the right end of an axis' ruler: its curves' signs, and their names and unit.
std::vector<LegendEntry> ruler_entries(const Plot& plot, int axis, const AxisScale& scale);
double ruler_column(const Plot& plot, const std::vector<AxisScale>& scales);

// Height below the diagram.
double axes_height(AxesKind kind, const Plot& plot);

// The grid, the frame around it, and zero where it is inside.
void draw_grid(SheetBuilder& builder, const PlotFrame& frame);

// Numbers and names outside the frame, from `left` on.
void draw_y_axis(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame, double left);
// ... and up to `right`.
void draw_x_axes(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame, AxesKind kind,
                 double right);

}  // namespace hull::drawing

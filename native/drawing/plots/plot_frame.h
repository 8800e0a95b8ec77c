// SPDX-License-Identifier: GPL-3.0-or-later
// Where the numbers of a plot are on the page, and its curves there.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "drawing/paper/sheet_builder.h"
#include "drawing/plots/plot.h"
#include "drawing/plots/plot_scale.h"

namespace hull::drawing {

struct PlotFrame {
  Eigen::AlignedBox2d area;       // the rectangle that the axes span
  std::vector<AxisScale> x_axes;  // one for each of the plot
  AxisScale y_axis;

  double page_x(int axis, double x) const {
    return area.min().x() + x_axes[axis].position(x) * area.sizes().x();
  }
  double page_y(double y) const { return area.max().y() - y_axis.position(y) * area.sizes().y(); }
  Eigen::Vector2d to_page(int axis, double x, double y) const {
    return {page_x(axis, x), page_y(y)};
  }
};

// The parts of a curve inside the frame's area. A part of one point is a single point that has no
// finite neighbours. Points less than a fiftieth of a millimetre apart are merged.
std::vector<PagePath> curve_paths(const PlotCurve& curve, const PlotFrame& frame);

// The polygons between a curve and y = 0 (or the nearest end of the y axis) for x in [from, to]:
// one for every run above or below.
std::vector<PagePath> area_polygons(const PlotCurve& curve, double from, double to,
                                    const PlotFrame& frame);

}  // namespace hull::drawing

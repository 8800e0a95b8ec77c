// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "drawing/paper/text_meter.h"
#include "drawing/plots/plot_pens.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

constexpr double kAxisNameSize = 2.8;
constexpr double kTick = 1.0;
constexpr double kLeastStepX = 14.0, kLeastStepY = 9.0;  // mm between numbers
constexpr double kNumberGap = 2.0;
constexpr double kLeastFineStep = 2.2;  // mm between lines of the fine grid
constexpr double kDotShare = 0.03;
constexpr double kRulerGap = 3.0;  // between the frame and the names beside the rulers

class Extent {
 public:
  void add(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  PlotRange range() const { return low_ <= high_ ? PlotRange{low_, high_} : PlotRange{0.0, 1.0}; }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

// Calls add(x axis, x, y) with every point that must be visible.
template <typename Add>
void for_each_shown_point(const Plot& plot, const Add& add) {
  for (const PlotCurve& curve : plot.curves) {
    for (std::size_t i = 0; i < curve.x.size() && !curve.guide; ++i) {
      if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
        add(curve.x_axis, curve.x[i], curve.y[i]);
      }
    }
  }
  for (const PlotMarker& marker : plot.markers) {
    if (marker.curve < 0) {
      add(0, marker.x, marker.y);
    } else if (!plot.curves[marker.curve].guide) {
      add(plot.curves[marker.curve].x_axis, marker.x, marker.y);
    }
  }
}

PlotRange x_range(const Plot& plot, int axis) {
  if (plot.x_axes[axis].range) return *plot.x_axes[axis].range;
  Extent extent;
  for_each_shown_point(plot, [&](int own, double x, double) {
    if (own == axis) extent.add(x);
  });
  for (const PlotLine& line : plot.lines) {
    if (line.vertical && axis == 0) extent.add(line.at);
  }
  return widened(extent.range(), plot.x_axes[axis].from_zero);
}

PlotRange y_range(const Plot& plot) {
  if (plot.y_axis.range) return *plot.y_axis.range;
  Extent extent;
  for_each_shown_point(plot, [&](int, double, double y) { extent.add(y); });
  for (const PlotLine& line : plot.lines) {
    if (!line.vertical) extent.add(line.at);
  }
  PlotRange range = widened(extent.range(), plot.y_axis.from_zero || !plot.areas.empty());
  // The dot at the top of a curve stays clear of the frame.
  const double dot_room = kDotShare * (range.high - range.low);
  for (const PlotMarker& marker : plot.markers) {
    const bool shown = marker.curve < 0 || !plot.curves[marker.curve].guide;
    if (shown) range.high = std::max(range.high, marker.y + dot_room);
  }
  return range;
}

AxisScale suited_scale(const PlotAxis& axis, const PlotRange& range, int steps) {
  return axis.range ? exact_scale(*axis.range, steps) : rounded_scale(range, steps);
}

// Where the middle of a number stands, `half` wide, when it must end before `right`.
Vector2d kept_left_of(double right, double half, Vector2d place) {
  place.x() = std::min(place.x(), right - half);
  return place;
}

void put_number(SheetBuilder& builder, const std::string& text, const Ink& ink,
                const Vector2d& place, double right) {
  const TextStyle style{.size = kNumberSize, .ink = ink};
  const double half = 0.5 * text_size(text, kNumberSize, false).width;
  builder.put_text(text, style,
                   SheetBuilder::text_box(text, style, kept_left_of(right, half, place)));
}

void put_name(SheetBuilder& builder, const std::string& text, const Vector2d& place, double room,
              double angle) {
  const FittedText fitted = fit_text(text, kAxisNameSize, false, room);
  const TextStyle style{.size = fitted.size};
  builder.put_text(fitted.text, style,
                   SheetBuilder::text_box(fitted.text, style, place, Align::kCentre, angle));
}

std::vector<int> curves_on(const Plot& plot, int axis) {
  std::vector<int> curves;
  for (int i = 0; i < static_cast<int>(plot.curves.size()); ++i) {
    if (plot.curves[i].x_axis == axis && !plot.curves[i].name.empty()) curves.push_back(i);
  }
  return curves;
}

void draw_ruler(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame, int axis,
                double right) {
  const std::vector<int> curves = curves_on(plot, axis);
  const Ink ink = curves.empty() ? inks::kBlack : colour_of(plot, curves.front());
  const double left_end = frame.area.min().x(), right_end = frame.area.max().x();
  const double y = frame.area.max().y() + 1.5 + axis * kRulerRow;
  const Pen pen{0.18, ink};
  builder.draw(pen, {{left_end, y}, {right_end, y}});
  const AxisScale& scale = frame.x_axes[axis];
  const Vector2d below(0.0, kTick + 1.4);
  for (const double tick : scale.ticks()) {
    const double x = frame.page_x(axis, tick);
    builder.draw(pen, {{x, y}, {x, y + kTick}});
    put_number(builder, scale.text(tick), ink, Vector2d(x, y) + below, right);
  }
  Vector2d place(right_end + kRulerGap + 2.0, y + 1.2);
  for (const LegendEntry& entry : ruler_entries(plot, axis, scale)) {
    if (entry.width > 0.0) draw_sign(builder, entry, place);
    place.x() += entry.width + kSignGap;
    const double width = text_size(entry.text, kNumberSize, false).width;
    const FittedText fitted =
        fit_text(entry.text, kNumberSize, false, std::max(std::min(width, right - place.x()), 4.0));
    const TextStyle style{.size = fitted.size, .ink = entry.pen.colour};
    if (place.x() + 4.0 <= right) {
      builder.put_text(fitted.text, style,
                       SheetBuilder::text_box(fitted.text, style, place, Align::kLeft));
    }
    place.x() += width + kSignGap;
  }
}

void draw_under(SheetBuilder& builder, const PlotFrame& frame, const std::string& name,
                const std::vector<std::pair<double, std::string>>& numbers, double right) {
  const double y = frame.area.max().y();
  for (const auto& [x, text] : numbers) {
    builder.draw(pens::kPlotFrame, {{x, y}, {x, y + kTick}});
    put_number(builder, text, inks::kBlack, {x, y + 0.5 * kNumberRow + 0.6}, right);
  }
  put_name(builder, name, {frame.area.center().x(), y + kNumberRow + 0.5 * kAxisNameRow + 0.4},
           frame.area.sizes().x(), 0.0);
}

}  // namespace

AxisScale y_scale(const Plot& plot, double height) {
  const int steps = std::clamp(static_cast<int>(height / kLeastStepY), 2, 14);
  return suited_scale(plot.y_axis, y_range(plot), steps);
}

std::vector<AxisScale> x_scales(const Plot& plot, double width) {
  const int count = static_cast<int>(plot.x_axes.size());
  std::vector<AxisScale> scales;
  // Fewer steps have shorter numbers too: tried until the widest number fits between two ticks.
  for (int steps = std::clamp(static_cast<int>(width / kLeastStepX), 2, 14);; --steps) {
    scales.clear();
    double room = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) {
      const PlotRange range = x_range(plot, i);
      // Several axes share the lines of one grid, so each is divided into as many steps.
      scales.push_back(count > 1 ? divided_scale(range, steps)
                                 : suited_scale(plot.x_axes[i], range, steps));
      // Room between the middles of neighbouring numbers, less the widest of them.
      const double step = scales.back().step / (scales.back().high - scales.back().low) * width;
      room = std::min(room, step - number_width(scales.back()));
    }
    if (room >= kNumberGap || steps <= 2) return scales;
  }
}

double number_width(const AxisScale& scale) {
  double width = 0.0;
  for (const double tick : scale.ticks()) {
    width = std::max(width, text_size(scale.text(tick), kNumberSize, false).width);
  }
  return width;
}

std::string axis_text(const PlotAxis& axis, const AxisScale& scale) {
  const std::string unit = scale.unit_text(axis.unit);
  if (unit.empty()) return axis.label;
  return (axis.label.empty() ? "" : axis.label + " ") + "[" + unit + "]";
}

std::vector<LegendEntry> ruler_entries(const Plot& plot, int axis, const AxisScale& scale) {
  std::vector<LegendEntry> entries;
  for (const int curve : curves_on(plot, axis)) {
    entries.push_back({LegendSign::kLine, pen_of(plot, curve), plot.curves[curve].name, 6.0});
  }
  const std::string unit = scale.unit_text(plot.x_axes[axis].unit);
  if (entries.empty()) {
    entries.push_back({LegendSign::kLine, pens::kFrame, axis_text(plot.x_axes[axis], scale), 0.0});
  } else if (!unit.empty()) {
    entries.back().text += " [" + unit + "]";
  }
  return entries;
}

double ruler_column(const Plot& plot, const std::vector<AxisScale>& scales) {
  double widest = 0.0;
  for (int i = 0; i < static_cast<int>(scales.size()); ++i) {
    double width = 0.0;
    for (const LegendEntry& entry : ruler_entries(plot, i, scales[i])) {
      width += entry.width + 2.0 * kSignGap + text_size(entry.text, kNumberSize, false).width;
    }
    widest = std::max(widest, width);
  }
  return widest + kRulerGap + 2.0;
}

double axes_height(AxesKind kind, const Plot& plot) {
  if (kind == AxesKind::kRulers) return static_cast<double>(plot.x_axes.size()) * kRulerRow + 1.5;
  return kNumberRow + kAxisNameRow + 0.8;
}

void draw_grid(SheetBuilder& builder, const PlotFrame& frame) {
  const Vector2d &low = frame.area.min(), &high = frame.area.max();
  const auto vertical = [&](const Pen& pen, double value) {
    const double x = frame.page_x(0, value);
    builder.draw(pen, {{x, low.y()}, {x, high.y()}});
  };
  const auto horizontal = [&](const Pen& pen, double value) {
    const double y = frame.page_y(value);
    builder.draw(pen, {{low.x(), y}, {high.x(), y}});
  };
  const auto wide_enough = [](const AxisScale& scale, double length) {
    return scale.step / scale.parts / (scale.high - scale.low) * length >= kLeastFineStep;
  };
  const AxisScale &x_axis = frame.x_axes[0], &y_axis = frame.y_axis;
  const bool fine_x = wide_enough(x_axis, frame.area.sizes().x());
  const bool fine_y = wide_enough(y_axis, frame.area.sizes().y());
  for (const double x : fine_x ? x_axis.fine_ticks() : std::vector<double>{}) {
    vertical(pens::kFineGrid, x);
  }
  for (const double y : fine_y ? y_axis.fine_ticks() : std::vector<double>{}) {
    horizontal(pens::kFineGrid, y);
  }
  for (const double x : x_axis.ticks()) vertical(pens::kPlotGrid, x);
  for (const double y : y_axis.ticks()) horizontal(pens::kPlotGrid, y);
  if (frame.x_axes.size() == 1 && x_axis.low < 0.0 && x_axis.high > 0.0) vertical(pens::kZero, 0.0);
  if (y_axis.low < 0.0 && y_axis.high > 0.0) horizontal(pens::kZero, 0.0);
  builder.draw(pens::kPlotFrame, outline_of(frame.area));
}

void draw_y_axis(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame, double left) {
  const double x = frame.area.min().x();
  const TextStyle style{.size = kNumberSize};
  for (const double tick : frame.y_axis.ticks()) {
    const double y = frame.page_y(tick);
    builder.draw(pens::kPlotFrame, {{x - kTick, y}, {x, y}});
    const std::string text = frame.y_axis.text(tick);
    builder.put_text(text, style,
                     SheetBuilder::text_box(text, style, {x - kTick - 0.8, y}, Align::kRight));
  }
  put_name(builder, axis_text(plot.y_axis, frame.y_axis),
           {left + 0.5 * kAxisNameRow - 0.4, frame.area.center().y()}, frame.area.sizes().y(),
           -0.5 * std::numbers::pi);
}

void draw_x_axes(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame, AxesKind kind,
                 double right) {
  if (kind == AxesKind::kRulers) {
    for (int i = 0; i < static_cast<int>(plot.x_axes.size()); ++i) {
      draw_ruler(builder, plot, frame, i, right);
    }
    return;
  }
  const AxisScale& scale = frame.x_axes[0];
  std::vector<std::pair<double, std::string>> numbers;
  for (const double tick : scale.ticks()) {
    const std::string text =
        kind == AxesKind::kSingle ? scale.text(tick) : std::to_string(numbers.size());
    numbers.emplace_back(frame.page_x(0, tick), text);
  }
  const std::string name =
      kind == AxesKind::kSingle ? axis_text(plot.x_axes[0], scale) : "Divisions (div)";
  draw_under(builder, frame, name, numbers, right);
}

}  // namespace hull::drawing

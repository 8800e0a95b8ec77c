// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/view_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "drawing/lines_plan/plan_layout.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

constexpr double kTickClearance = 0.4;  // mm
constexpr double kCaptionSize = 3.5;

// A length of a curve that a label can take the place of.
struct Slot {
  Vector2d centre;
  double angle;
};

// Into (-90, 90] degrees, so that no label stands on its head.
double turned_upright(double angle) {
  if (angle > 0.5 * std::numbers::pi) return angle - std::numbers::pi;
  if (angle <= -0.5 * std::numbers::pi) return angle + std::numbers::pi;
  return angle;
}

std::vector<double> arc_lengths(const PagePath& path) {
  std::vector<double> lengths(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths[i] = lengths[i - 1] + (path[i] - path[i - 1]).norm();
  }
  return lengths;
}

Vector2d point_at(const PagePath& path, const std::vector<double>& lengths, double length) {
  // Strictly beyond, while the point before is not: the divisor is never nothing, though points may
  // be there twice.
  const auto upper = std::upper_bound(lengths.begin(), lengths.end(), length);
  if (upper == lengths.begin()) return path.front();
  // At the very end, or beyond it by rounding.
  if (upper == lengths.end()) return path.back();
  const auto i = upper - lengths.begin();
  const double t = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
  return path[i - 1] + t * (path[i] - path[i - 1]);
}

// The slots of `width` along the path, at most `bend` away from straight, every millimetre or so.
std::vector<Slot> slots_along(const PagePath& path, double width, double bend) {
  const std::vector<double> lengths = arc_lengths(path);
  const double total = lengths.back();
  std::vector<Slot> slots;
  // A label that took most of a curve would hide it.
  if (total < 3.0 * width) return slots;
  const int count = std::clamp(static_cast<int>(total), 10, 600);
  for (int k = 0; k <= count; ++k) {
    // Half a width is left free at either end of the curve.
    const double middle = width + (total - 2.0 * width) * k / count;
    const Vector2d start = point_at(path, lengths, middle - 0.5 * width);
    const Vector2d end = point_at(path, lengths, middle + 0.5 * width);
    const Vector2d centre = point_at(path, lengths, middle);
    // The sagitta of the stretch: a straight label would leave a bent curve.
    if ((centre - 0.5 * (start + end)).norm() > bend) continue;
    const Vector2d chord = end - start;
    slots.push_back({centre, turned_upright(std::atan2(chord.y(), chord.x()))});
  }
  return slots;
}

const PlacedCurve* longest(const std::vector<PlacedCurve>& curves) {
  const auto length = [](const PlacedCurve& curve) { return arc_lengths(curve.path).back(); };
  const auto found = std::max_element(
      curves.begin(), curves.end(),
      [&](const PlacedCurve& a, const PlacedCurve& b) { return length(a) < length(b); });
  return found == curves.end() ? nullptr : &*found;
}

void put_first_ones_first(std::vector<Tick>& ticks) {
  // Where there is not room for all, those placed first get it.
  std::stable_partition(ticks.begin(), ticks.end(), [](const Tick& tick) { return tick.first; });
}

}  // namespace

Projection projection(const View& view, const Eigen::RowVector3d& right,
                      const Eigen::RowVector3d& up) {
  Projection shown;
  shown.linear.row(0) = view.scale * right;
  // On paper y runs down.
  shown.linear.row(1) = -view.scale * up;
  shown.shift = view.origin;
  return shown;
}

PlacedCurve draw_ship_curve(SheetBuilder& builder, const Pen& pen, const Projection& shown,
                            const ShipCurve& curve) {
  const auto on_page = [&shown](const std::vector<Eigen::Vector3d>& points) {
    PagePath path;
    path.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
      path.emplace_back(shown.linear * point + shown.shift);
    }
    return path;
  };
  PagePath path = on_page(curve.points);
  std::optional<PageSpline> spline;
  // An affine map, which takes a spline's control points along with the curve.
  if (curve.spline) spline = PageSpline{on_page(curve.spline->points()), curve.spline->knots()};
  const int number = builder.draw_curve(pen, path, std::move(spline));
  return {std::move(path), number};
}

void draw_perpendiculars(SheetBuilder& builder, const View& view, const GridBox& grid,
                         const LinesDrawing& drawing, const HullExtents& extents, bool labelled) {
  if (!drawing.length) return;
  std::vector<Tick> ticks;
  const auto add = [&](double x, const Pen& pen, const std::string& name) {
    if (x < extents.aft || x > extents.fore) return;
    const double page_x = view.to_page(x, 0.0).x();
    draw_vertical(builder, pen, grid, page_x);
    ticks.push_back({page_x, name, inks::kBlack, true});
  };
  add(0.0, pens::kPerpendicular, "AP");
  add(extents.midship, pens::kMidship, "Midship");
  add(*drawing.length, pens::kPerpendicular, "FP");
  if (labelled) {
    label_verticals(builder, view, std::move(ticks), grid.min().y() - 0.5 * kLabelRow);
  }
}

void draw_caption(SheetBuilder& builder, const View& view, const std::string& text) {
  const TextStyle style{.size = kCaptionSize, .bold = true};
  const Vector2d corner = view.bounds.min() + Vector2d(0.0, 0.5 * kCaptionSize);
  builder.put_text(text, style, SheetBuilder::text_box(text, style, corner, Align::kLeft));
}

void draw_vertical(SheetBuilder& builder, const Pen& pen, const GridBox& grid, double x) {
  builder.draw(pen, {{x, grid.min().y()}, {x, grid.max().y()}});
}

void draw_horizontal(SheetBuilder& builder, const Pen& pen, const GridBox& grid, double y) {
  builder.draw(pen, {{grid.min().x(), y}, {grid.max().x(), y}});
}

void label_verticals(SheetBuilder& builder, const View& view, std::vector<Tick> ticks, double y) {
  put_first_ones_first(ticks);
  for (const Tick& tick : ticks) {
    const TextStyle style{.ink = tick.ink};
    const OrientedBox box = SheetBuilder::text_box(tick.text, style, {tick.at, y});
    if (builder.has_room(box, kTickClearance, view.bounds)) builder.put_text(tick.text, style, box);
  }
}

void label_horizontals(SheetBuilder& builder, const View& view, const GridBox& grid,
                       std::vector<Tick> ticks) {
  put_first_ones_first(ticks);
  for (const Tick& tick : ticks) {
    const TextStyle style{.ink = tick.ink};
    const auto put = [&](double x, Align align) {
      const OrientedBox box = SheetBuilder::text_box(tick.text, style, {x, tick.at}, align);
      if (builder.has_room(box, 0.2, view.bounds)) builder.put_text(tick.text, style, box);
    };
    put(grid.min().x() - kColumnGap, Align::kRight);
    put(grid.max().x() + kColumnGap, Align::kLeft);
  }
}

void label_on_curve(SheetBuilder& builder, const View& view, const std::vector<PlacedCurve>& curves,
                    const std::string& text, Ink ink, const std::vector<double>& wanted) {
  const PlacedCurve* curve = longest(curves);
  if (!curve) return;
  const TextStyle style{.size = 2.4, .ink = ink, .knockout = true};
  const double width = SheetBuilder::text_box(text, style, {0.0, 0.0}).half.x() * 2.0;
  std::vector<Slot> slots = slots_along(curve->path, width, 0.15 * style.size);
  for (const double x : wanted) {
    // Stable, so that of two slots equally near the first along the curve is taken on every
    // machine.
    std::stable_sort(slots.begin(), slots.end(), [x](const Slot& a, const Slot& b) {
      return std::abs(a.centre.x() - x) < std::abs(b.centre.x() - x);
    });
    // Farther away the next place that is wanted is tried instead.
    const double reach = 0.25 * view.bounds.sizes().x();
    for (const Slot& slot : slots) {
      // Sorted by distance: those that follow are farther yet.
      if (std::abs(slot.centre.x() - x) > reach) break;
      const OrientedBox box =
          SheetBuilder::text_box(text, style, slot.centre, Align::kCentre, slot.angle);
      // The curve itself gives way: the label is knocked out of it.
      if (!builder.has_room(box, 0.3, view.bounds, curve->number)) continue;
      builder.put_text(text, style, box);
      return;
    }
  }
}

bool is_design_waterline(const LinesDrawing& drawing, const NamedCurves& waterline) {
  return drawing.draft &&
         std::abs(waterline.position - *drawing.draft) <= 1e-6 * std::abs(*drawing.draft);
}

void draw_stations(SheetBuilder& builder, const View& view, const GridBox& grid,
                   const LinesDrawing& drawing, const HullExtents& extents) {
  std::vector<Tick> ticks;
  for (const NamedCurves& station : drawing.stations) {
    if (station.position < extents.aft || station.position > extents.fore) continue;
    const double x = view.to_page(station.position, 0.0).x();
    draw_vertical(builder, pens::kGrid, grid, x);
    ticks.push_back({x, station.label, inks::kStation, false});
  }
  label_verticals(builder, view, std::move(ticks), grid.max().y() + 0.5 * kLabelRow);
}

void draw_heights(SheetBuilder& builder, const View& view, const GridBox& grid,
                  const LinesDrawing& drawing, double bottom, double top) {
  std::vector<Tick> ticks;
  const auto within = [&](double z) { return z >= bottom && z <= top; };
  for (const NamedCurves& waterline : drawing.waterlines) {
    if (!within(waterline.position)) continue;
    // Heavier, and named before its neighbours where there is not room for all.
    const bool design = is_design_waterline(drawing, waterline);
    const double y = view.to_page(0.0, waterline.position).y();
    draw_horizontal(builder, design ? pens::kDesignWaterline : pens::kGrid, grid, y);
    ticks.push_back({y, waterline.label, inks::kWaterline, design});
  }
  if (within(0.0)) {
    const double y = view.to_page(0.0, 0.0).y();
    draw_horizontal(builder, pens::kBaseline, grid, y);
    ticks.push_back({y, "BL", inks::kBlack, true});
  }
  label_horizontals(builder, view, grid, std::move(ticks));
}

}  // namespace hull::drawing

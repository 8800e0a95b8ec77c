// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_marks.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "drawing/plots/plot_pens.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kDotRadius = 0.8;
constexpr int kDotCorners = 20;
constexpr double kMarkSize = 2.5;
constexpr double kClearance = 0.5;
constexpr double kLeaderFrom = 4.0;  // longer distances get a leader

int axis_of(const Plot& plot, const PlotMarker& marker) {
  return marker.curve < 0 ? 0 : plot.curves[marker.curve].x_axis;
}

Ink ink_of(const Plot& plot, const PlotMarker& marker) {
  return marker.curve < 0 ? inks::kBlack : colour_of(plot, marker.curve);
}

// The box of a text that lies beyond `distance` from the point, in this direction.
OrientedBox box_beside(const std::string& text, const TextStyle& style, const Vector2d& point,
                       const Vector2d& direction, double distance) {
  OrientedBox box = SheetBuilder::text_box(text, style, point);
  // Along an axis the middle of the box's side comes nearest, along a diagonal its corner.
  box.centre += Vector2d(direction.x() * (box.half.x() + distance),
                         direction.y() * (box.half.y() + distance));
  return box;
}

bool put_marker_text(SheetBuilder& builder, const std::string& text, const Ink& ink,
                     const Vector2d& dot, const AlignedBox2d& bounds) {
  // The corners first: beside a dot on a curve they are where the curve most seldom is.
  static const std::array<Vector2d, 8> kDirections{
      {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};
  const TextStyle style{.size = kMarkSize, .ink = ink, .knockout = true};
  // All directions at one distance before the next: the text is as near as there is room.
  for (const double distance : {0.8, 1.6, 2.8, 4.5, 7.0, 10.0, 14.0}) {
    for (const Vector2d& direction : kDirections) {
      const OrientedBox box = box_beside(text, style, dot, direction, distance + 0.5 * kDotRadius);
      if (!builder.has_room(box, kClearance, bounds)) continue;
      if (distance > kLeaderFrom) {
        // The corner of the box that is nearest to the dot, or the middle of its side.
        const Vector2d end = dot + (distance + 0.5 * kDotRadius) * direction;
        // Outside the dot's own box, along a diagonal as well.
        const Vector2d begin = dot + (kDotRadius + 0.2) * direction;
        if (!builder.placer().is_free(begin, end)) continue;
        builder.draw(pens::kLeader, {begin, end});
      }
      builder.put_text(text, style, box);
      return true;
    }
  }
  return false;
}

// Along a vertical line, reading upwards, or upon a horizontal one: near its end first.
bool put_line_text(SheetBuilder& builder, const PlotLine& line, const Vector2d& from,
                   const Vector2d& to, const AlignedBox2d& bounds) {
  const TextStyle style{.size = kMarkSize, .ink = inks::kGrey, .knockout = true};
  const double angle = line.vertical ? -0.5 * std::numbers::pi : 0.0;
  const Vector2d along = (to - from).normalized();
  // Up from a horizontal line, to the left of a vertical one; the other hand is tried first.
  const Vector2d aside(along.y(), -along.x());
  OrientedBox box = SheetBuilder::text_box(line.label, style, from, Align::kCentre, angle);
  const double length = (to - from).norm();
  const double half = box.half.x() + 1.0;
  constexpr int kTries = 24;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i <= kTries; ++i) {
      // From the line's end to its begin, the whole text within.
      const double at = length - half - (length - 2.0 * half) * i / kTries;
      // A text longer than its line finds no place.
      if (at < half) continue;
      box.centre = from + at * along + side * (box.half.y() + 0.8) * aside;
      if (!builder.has_room(box, 0.3, bounds)) continue;
      builder.put_text(line.label, style, box);
      return true;
    }
  }
  return false;
}

// The point at a share of a path's length, and the direction there.
struct PathPoint {
  Vector2d at, along;
};

PathPoint point_along(const PagePath& path, double share) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  double rest = share * length;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector2d step = path[i] - path[i - 1];
    if (rest <= step.norm() || i + 1 == path.size()) {
      const Vector2d along = step.normalized();
      return {path[i - 1] + std::min(rest, step.norm()) * along, along};
    }
    rest -= step.norm();
  }
  return {path.front(), Vector2d::UnitX()};
}

// Near the ends of curves they are apart; the shares are tried in this order.
constexpr std::array<double, 11> kShares{0.93, 0.85, 0.77, 0.68, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 1.0};

bool put_symbol(SheetBuilder& builder, const std::string& text, const TextStyle& style,
                const PagePath& path, int number, const AlignedBox2d& bounds) {
  for (const double share : kShares) {
    const PathPoint point = point_along(path, share);
    // On the curve, which it interrupts, as long as no other is near.
    const OrientedBox box = SheetBuilder::text_box(text, style, point.at);
    if (builder.has_room(box, kClearance, bounds, number)) {
      builder.put_text(text, style, box);
      return true;
    }
    const Vector2d normal(-point.along.y(), point.along.x());
    // Then beside it, on either hand.
    for (const double side : {1.0, -1.0}) {
      const OrientedBox beside = box_beside(text, style, point.at, side * normal, 0.9);
      if (builder.has_room(beside, 0.3, bounds)) {
        builder.put_text(text, style, beside);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

PagePath dot_outline(const Vector2d& centre) {
  PagePath outline;
  for (int i = 0; i < kDotCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDotCorners;
    outline.push_back(centre + kDotRadius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

Unlabelled draw_marks(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame,
                      const Unlabelled& in_legend) {
  Unlabelled without = in_legend;
  struct Trace {
    int number;
    Vector2d from, to;
  };
  std::vector<Trace> traces;
  for (int i = 0; i < static_cast<int>(plot.lines.size()); ++i) {
    const PlotLine& line = plot.lines[i];
    const AxisScale& scale = line.vertical ? frame.x_axes[0] : frame.y_axis;
    if (line.at < scale.low || line.at > scale.high) {
      // Out of sight, but not unknown where it has a name.
      if (!line.label.empty()) without.lines.insert(i);
      continue;
    }
    const Vector2d &low = frame.area.min(), &high = frame.area.max();
    const double x = frame.page_x(0, line.at), y = frame.page_y(line.at);
    // A vertical line runs up the page, as its text does.
    const Trace trace = line.vertical ? Trace{i, {x, high.y()}, {x, low.y()}}
                                      : Trace{i, {low.x(), y}, {high.x(), y}};
    builder.draw_curve(pens::kReference, {trace.from, trace.to});
    traces.push_back(trace);
  }
  std::vector<std::optional<Vector2d>> dots;
  for (const PlotMarker& marker : plot.markers) {
    const Vector2d dot = frame.to_page(axis_of(plot, marker), marker.x, marker.y);
    const bool seen = frame.area.exteriorDistance(dot) < 1e-9;
    // Marks out of sight keep their place in the list, which is by number.
    dots.push_back(seen ? std::optional(dot) : std::nullopt);
    if (!seen) continue;
    builder.fill(ink_of(plot, marker), dot_outline(dot));
    builder.occupy({dot, Vector2d::Constant(kDotRadius)});
  }
  // Only now, when all dots are obstacles: none is hidden by the text of another.
  for (int i = 0; i < static_cast<int>(plot.markers.size()); ++i) {
    const PlotMarker& marker = plot.markers[i];
    if (marker.label.empty() || in_legend.markers.contains(i)) continue;
    if (!dots[i]) {
      // Who reads the legend learns of a curve's point out of sight, but a guide has its name.
      const bool guide = marker.curve >= 0 && plot.curves[marker.curve].guide;
      if (!guide) without.markers.insert(i);
    } else if (!put_marker_text(builder, marker.label, ink_of(plot, marker), *dots[i],
                                frame.area)) {
      without.markers.insert(i);
    }
  }
  // After the markers' texts, as these can't move along a line.
  for (const Trace& trace : traces) {
    const PlotLine& line = plot.lines[trace.number];
    if (!line.label.empty() && !in_legend.lines.contains(trace.number) &&
        !put_line_text(builder, line, trace.from, trace.to, frame.area)) {
      without.lines.insert(trace.number);
    }
  }
  return without;
}

void draw_symbols(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame,
                  const std::vector<PlottedCurve>& curves) {
  for (const PlottedCurve& plotted : curves) {
    const std::string& symbol = plot.curves[plotted.curve].symbol;
    if (symbol.empty()) continue;
    const TextStyle style{
        .size = kMarkSize, .ink = colour_of(plot, plotted.curve), .knockout = true};
    // From the last part on: near the ends of curves they are apart.
    for (std::size_t i = plotted.paths.size(); i-- > 0;) {
      if (plotted.paths[i].size() < 2) continue;
      if (put_symbol(builder, symbol, style, plotted.paths[i], plotted.numbers[i], frame.area)) {
        break;
      }
    }
  }
}

}  // namespace hull::drawing

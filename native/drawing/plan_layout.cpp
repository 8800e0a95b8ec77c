// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plan_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace hull {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kPaperMargin = 10.0;  // paper edge to frame
constexpr double kFramePadding = 4.0;  // frame to views
constexpr double kViewGap = 4.0;       // least distance of two views

struct Margins {
  double left, right, top, bottom;
};

// One view: the size of the hull in it and what is kept around the hull, mm.
struct ViewSize {
  double hull_width, hull_height;
  Margins margins;

  double width() const { return margins.left + hull_width + margins.right; }
  double height() const { return margins.top + hull_height + margins.bottom; }
};

struct ViewSizes {
  ViewSize profile, half_breadth, body_plan;
};

ViewSizes view_sizes(const HullExtents& extents, double scale, double label_column) {
  const double length = scale * (extents.fore - extents.aft);
  const double breadth = scale * extents.breadth;
  const double depth = scale * (extents.top - extents.bottom);
  const double column = label_column + kColumnGap;
  const double side = kOverhang + column;
  const double body_side = kSideOverhang + column;
  const double foot = kOverhang + kLabelRow;
  // Profile and body plan share their heights, so that side by side they share the base line.
  const double head = kCaptionRow + std::max(kLabelRow + kOverhang, kFanRow);
  return {{length, depth, {side, side, head, foot}},
          {length, breadth, {side, side, kCaptionRow + kOverhang, foot}},
          {2.0 * breadth, depth, {body_side, body_side, head, foot}}};
}

AlignedBox2d box_at(double left, double top, double width, double height) {
  return {Vector2d(left, top), Vector2d(left + width, top + height)};
}

// The view of `size` with its bounds' upper left corner at (left, top), and ship coordinates
// (right, up) at the hull's lower left corner.
View place(const ViewSize& size, double left, double top, double scale, double right, double up) {
  const double corner_x = left + size.margins.left;
  const double corner_y = top + size.margins.top + size.hull_height;
  return {box_at(left, top, size.width(), size.height()),
          Vector2d(corner_x - scale * right, corner_y + scale * up), scale};
}

struct Corners {
  Vector2d profile, half_breadth, body_plan;  // upper left corners of the views
};

// Profile, half-breadth plan and body plan from top to bottom, the body plan left of the title
// block.
std::optional<Corners> stacked(const ViewSizes& sizes, const AlignedBox2d& area,
                               const AlignedBox2d& title) {
  const double left_width = title.min().x() - kViewGap - area.min().x();
  const double heights =
      sizes.profile.height() + sizes.half_breadth.height() + sizes.body_plan.height();
  const double rest = area.sizes().y() - heights;
  if (sizes.profile.width() > area.sizes().x() || sizes.body_plan.width() > left_width ||
      rest < 2.0 * kViewGap) {
    return std::nullopt;
  }
  const double gap = rest / 4.0;
  const double left = area.center().x() - 0.5 * sizes.profile.width();
  const double profile_top = area.min().y() + gap;
  const double half_breadth_top = profile_top + sizes.profile.height() + gap;
  if (half_breadth_top + sizes.half_breadth.height() + kViewGap > title.min().y()) {
    return std::nullopt;
  }
  const double body_plan_top = half_breadth_top + sizes.half_breadth.height() + gap;
  return Corners{{left, profile_top},
                 {left, half_breadth_top},
                 {area.min().x() + 0.5 * (left_width - sizes.body_plan.width()), body_plan_top}};
}

// The body plan beside the profile, above the title block.
std::optional<Corners> side_by_side(const ViewSizes& sizes, const AlignedBox2d& area,
                                    const AlignedBox2d& title) {
  const double right_width = std::max(sizes.body_plan.width(), area.max().x() - title.min().x());
  const double rest_x = area.sizes().x() - sizes.profile.width() - right_width;
  const double rest_y = area.sizes().y() - sizes.profile.height() - sizes.half_breadth.height();
  if (rest_x < kViewGap || rest_y < kViewGap) return std::nullopt;
  const double gap_x = rest_x / 3.0;
  const double gap_y = rest_y / 3.0;
  const double top = area.min().y() + gap_y;
  if (top + sizes.body_plan.height() + kViewGap > title.min().y()) return std::nullopt;
  const double left = area.min().x() + gap_x;
  const double body_plan_left =
      area.max().x() - gap_x - 0.5 * (right_width + sizes.body_plan.width());
  return Corners{{left, top}, {left, top + sizes.profile.height() + gap_y}, {body_plan_left, top}};
}

std::vector<double> usual_denominators() {
  std::vector<double> all;
  // Enlargements keep to 2:1, 5:1, 10:1, ...
  for (const double power : {0.0001, 0.001, 0.01, 0.1}) {
    for (const double mantissa : {1.0, 2.0, 5.0}) all.push_back(mantissa * power);
  }
  for (double power = 1.0; power < 1e7; power *= 10.0) {
    for (const double mantissa : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.0}) {
      all.push_back(mantissa * power);
    }
  }
  return all;
}

void extend_by_curves(Eigen::AlignedBox3d& box, const std::vector<ShipCurve>& curves,
                      const std::string& owner) {
  for (const ShipCurve& curve : curves) {
    if (curve.size() < 2) {
      throw std::invalid_argument("A curve of " + owner + " has less than two points");
    }
    for (const Eigen::Vector3d& point : curve) {
      if (!point.allFinite()) {
        throw std::invalid_argument("A point of " + owner + " is not a finite number");
      }
      box.extend(point);
    }
  }
}

void extend_by_family(Eigen::AlignedBox3d& box, const std::vector<NamedCurves>& family,
                      const std::string& kind) {
  for (const NamedCurves& member : family) {
    const std::string owner = kind + " \"" + member.label + "\"";
    if (!std::isfinite(member.position)) {
      throw std::invalid_argument("The position of " + owner + " is not a finite number");
    }
    extend_by_curves(box, member.curves, owner);
  }
}

void check_dimension(const std::optional<double>& value, const std::string& name) {
  if (value && !std::isfinite(*value)) {
    throw std::invalid_argument("The " + name + " is not a finite number");
  }
}

}  // namespace

HullExtents hull_extents(const LinesDrawing& drawing) {
  Eigen::AlignedBox3d box;
  extend_by_family(box, drawing.stations, "station");
  extend_by_family(box, drawing.waterlines, "waterline");
  extend_by_family(box, drawing.buttocks, "buttock");
  extend_by_curves(box, drawing.outlines, "the outline");
  extend_by_curves(box, drawing.knuckles, "a knuckle");
  if (box.isEmpty()) {
    throw std::invalid_argument(
        "There is nothing to draw: no station, waterline or buttock cuts the hull");
  }
  const double size = box.sizes().maxCoeff();
  if (size < 1e-3 || size > 1e5) {
    throw std::invalid_argument("The hull is " + std::to_string(size) +
                                " m large; a lines plan can be drawn from 1 mm to 100 km");
  }
  check_dimension(drawing.draft, "draft");
  check_dimension(drawing.length, "length between perpendiculars");
  if (drawing.length && *drawing.length <= 0.0) {
    throw std::invalid_argument("The length between perpendiculars must be above zero, not " +
                                std::to_string(*drawing.length) + " m");
  }

  HullExtents extents{box.min().x(), box.max().x(), std::max(box.max().y(), 0.0),
                      box.min().z(), box.max().z(), 0.5 * (box.min().x() + box.max().x())};
  const auto near = [](double value, double low, double high) {
    const double reach = 0.25 * (high - low);
    return value > low - reach && value < high + reach;
  };
  if (drawing.length) {
    extents.midship = 0.5 * *drawing.length;
    for (const double perpendicular : {0.0, *drawing.length}) {
      if (near(perpendicular, box.min().x(), box.max().x())) {
        extents.aft = std::min(extents.aft, perpendicular);
        extents.fore = std::max(extents.fore, perpendicular);
      }
    }
  }
  if (near(0.0, box.min().z(), box.max().z())) {
    extents.bottom = std::min(extents.bottom, 0.0);
    extents.top = std::max(extents.top, 0.0);
  }
  return extents;
}

LinesSheet choose_layout(const HullExtents& extents, Paper paper, double label_column,
                         const Vector2d& title_block) {
  const PaperSize size = paper_size(paper);
  LinesSheet sheet{};
  sheet.width = size.width;
  sheet.height = size.height;
  sheet.frame = box_at(kPaperMargin, kPaperMargin, size.width - 2.0 * kPaperMargin,
                       size.height - 2.0 * kPaperMargin);
  sheet.title_block = {sheet.frame.max() - title_block, sheet.frame.max()};
  const Vector2d padding = Vector2d::Constant(kFramePadding);
  const AlignedBox2d area(sheet.frame.min() + padding, sheet.frame.max() - padding);

  for (const double denominator : usual_denominators()) {
    const double scale = 1000.0 / denominator;
    const ViewSizes sizes = view_sizes(extents, scale, label_column);
    std::optional<Corners> corners = side_by_side(sizes, area, sheet.title_block);
    if (!corners) corners = stacked(sizes, area, sheet.title_block);
    if (!corners) continue;
    sheet.scale_denominator = denominator;
    const auto at = [&](const ViewSize& view, const Vector2d& corner, double right, double up) {
      return place(view, corner.x(), corner.y(), scale, right, up);
    };
    sheet.profile = at(sizes.profile, corners->profile, extents.aft, extents.bottom);
    sheet.half_breadth = at(sizes.half_breadth, corners->half_breadth, extents.aft, 0.0);
    sheet.body_plan = at(sizes.body_plan, corners->body_plan, -extents.breadth, extents.bottom);
    return sheet;
  }
  throw std::invalid_argument("The labels and particulars leave no room for the hull on " +
                              size.name + ": shorten them or take larger paper");
}

std::string scale_text(double denominator) {
  char text[32];
  if (denominator >= 1.0) {
    std::snprintf(text, sizeof text, "1:%g", denominator);
  } else {
    std::snprintf(text, sizeof text, "%g:1", 1.0 / denominator);
  }
  return text;
}

}  // namespace hull

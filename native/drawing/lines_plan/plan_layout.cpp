// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/plan_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "drawing/lines_plan/plan_arrangements.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kPaperMargin = 10.0;  // paper edge to frame
constexpr double kFramePadding = 4.0;  // frame to views

struct Margins {
  double left, right, top, bottom;
};

// One view: the size of the hull in it and what is kept around the hull, mm.
struct ViewSize {
  double hull_width, hull_height;
  Margins margins;

  Vector2d size() const {
    return {margins.left + hull_width + margins.right, margins.top + hull_height + margins.bottom};
  }
};

struct ViewSizes {
  ViewSize profile, half_breadth, body_plan;
};

ViewSizes view_sizes(const PlanNeeds& needs, double scale) {
  const HullExtents& extents = needs.extents;
  const double length = scale * (extents.fore - extents.aft);
  const double breadth = scale * extents.breadth;
  const double depth = scale * (extents.top - extents.bottom);
  const double column = needs.label_column + kColumnGap;
  const double side = kOverhang + column;
  const double body_side = kSideOverhang + column;
  const double foot = kOverhang + kLabelRow;
  const double profile_foot = foot + (needs.has_frames ? kFrameRow : 0.0);
  // Profile and body plan share their heights, so that side by side they share the base line.
  const double head = kCaptionRow + std::max(kLabelRow + kOverhang, kFanRow);
  const ViewSize none{0.0, 0.0, {0.0, 0.0, 0.0, 0.0}};
  ViewSizes sizes{
      {length, depth, {side, side, head, profile_foot}},
      {length, breadth + scale * extents.diagonals, {side, side, kCaptionRow + kOverhang, foot}},
      {2.0 * breadth, depth, {body_side, body_side, head, profile_foot}}};
  // Without any size it keeps its place in the arrangements.
  if (!needs.views.profile) sizes.profile = none;
  if (!needs.views.half_breadth) sizes.half_breadth = none;
  if (!needs.views.body_plan) sizes.body_plan = none;
  return sizes;
}

// The view of `size` with its bounds' upper left corner at `corner`, and ship coordinates (right,
// up) at the hull's lower left corner.
View place(const ViewSize& size, const Vector2d& corner, double scale, double right, double up) {
  // The hull's lower left corner on the page; the origin is as far from it as ship coordinates say.
  const double corner_x = corner.x() + size.margins.left;
  const double corner_y = corner.y() + size.margins.top + size.hull_height;
  return {AlignedBox2d(corner, corner + size.size()),
          Vector2d(corner_x - scale * right, corner_y + scale * up), scale};
}

std::vector<double> usual_denominators() {
  std::vector<double> all;
  // Enlargements keep to 2:1, 5:1, 10:1, ...
  // From the largest scale to the smallest.
  for (const double power : {0.0001, 0.001, 0.01, 0.1}) {
    for (const double mantissa : {1.0, 2.0, 5.0}) all.push_back(mantissa * power);
  }
  for (double power = 1.0; power < 1e7; power *= 10.0) {
    for (const double mantissa : {1.0, 1.25, 2.0, 2.5, 3.0, 5.0, 7.5}) {
      all.push_back(mantissa * power);
    }
  }
  return all;
}

AlignedBox2d frame_of(const PaperSize& paper) {
  const Vector2d margin = Vector2d::Constant(kPaperMargin);
  return {margin, Vector2d(paper.width, paper.height) - margin};
}

// Finds the views' places at this scale; false if there is no room.
bool place_all(LinesSheet& sheet, const PlanNeeds& needs, double denominator) {
  const double scale = 1000.0 / denominator;
  const ViewSizes sizes = view_sizes(needs, scale);
  const Vector2d padding = Vector2d::Constant(kFramePadding);
  const AlignedBox2d area(sheet.frame.min() + padding, sheet.frame.max() - padding);
  PlanBlocks blocks{sizes.profile.size(), sizes.half_breadth.size(), sizes.body_plan.size(), {}};
  std::optional<PlanCorners> corners;
  const int forms = std::max<int>(1, static_cast<int>(needs.tables.size()));
  // All forms of the table at this scale before the next smaller one: rather small letters than a
  // small hull.
  for (int form = 0; form < forms && !corners; ++form) {
    if (!needs.tables.empty()) blocks.table = needs.tables[form];
    corners = arrange_plan(blocks, area, sheet.title_block);
    sheet.table_form = form;
  }
  if (!corners) return false;
  sheet.scale_denominator = denominator;
  // Empty without one, by which the drawing knows.
  if (blocks.table) sheet.table = AlignedBox2d(corners->table, corners->table + *blocks.table);
  const HullExtents& extents = needs.extents;
  sheet.profile = place(sizes.profile, corners->profile, scale, extents.aft, extents.bottom);
  sheet.half_breadth =
      place(sizes.half_breadth, corners->half_breadth, scale, extents.aft, -extents.diagonals);
  sheet.body_plan =
      place(sizes.body_plan, corners->body_plan, scale, -extents.breadth, extents.bottom);
  return true;
}

// Whether a usual scale fits; the largest of them.
bool place_at_usual_scale(LinesSheet& sheet, const PlanNeeds& needs) {
  for (const double denominator : usual_denominators()) {
    if (place_all(sheet, needs, denominator)) return true;
  }
  return false;
}

[[noreturn]] void refuse_scale(LinesSheet& sheet, const PlanNeeds& needs) {
  std::string message = "At " + scale_text(*needs.scale_denominator);
  message += " the lines plan does not fit " + needs.paper.name;
  // The sheet only serves to find it, as nothing returns from here.
  if (place_at_usual_scale(sheet, needs)) {
    message += "; " + scale_text(sheet.scale_denominator) + " does";
  }
  throw std::invalid_argument(message + ". Take a smaller scale or larger paper");
}

}  // namespace

LinesSheet choose_layout(const PlanNeeds& needs) {
  LinesSheet sheet{};
  sheet.width = needs.paper.width;
  sheet.height = needs.paper.height;
  sheet.frame = frame_of(needs.paper);
  sheet.title_block = {sheet.frame.max() - needs.title_block, sheet.frame.max()};
  sheet.table.setEmpty();
  if (!sheet.frame.contains(sheet.title_block)) {
    throw std::invalid_argument("The title block has no room on " + needs.paper.name +
                                ": take larger paper or fewer particulars");
  }
  if (needs.scale_denominator) {
    const double denominator = *needs.scale_denominator;
    if (!std::isfinite(denominator) || denominator <= 0.0) {
      throw std::invalid_argument("The scale 1:" + std::to_string(denominator) +
                                  " is none: give a number above zero, 100 for 1:100");
    }
    if (!place_all(sheet, needs, denominator)) refuse_scale(sheet, needs);
    return sheet;
  }
  if (place_at_usual_scale(sheet, needs)) return sheet;
  // Only to tell what is in the way.
  PlanNeeds without_table = needs;
  without_table.tables.clear();
  if (!needs.tables.empty() && place_at_usual_scale(sheet, without_table)) {
    throw std::invalid_argument("The table of offsets leaves no room for the hull on " +
                                needs.paper.name +
                                ": take larger paper or fewer lines, or leave the table out");
  }
  throw std::invalid_argument("The labels and particulars leave no room for the hull on " +
                              needs.paper.name + ": shorten them or take larger paper");
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

}  // namespace hull::drawing

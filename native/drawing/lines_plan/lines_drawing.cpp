// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/lines_drawing.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "drawing/lines_plan/hull_extents.h"
#include "drawing/lines_plan/lines_dxf.h"
#include "drawing/lines_plan/lines_views.h"
#include "drawing/lines_plan/offsets_block.h"
#include "drawing/lines_plan/plan_layout.h"
#include "drawing/lines_plan/title_block.h"
#include "drawing/paper/canvas.h"
#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

namespace {

// Lines nearer than this on average, mm, run together.
constexpr double kNearestLines = 0.5;

// The width of the widest label beside a grid.
double label_column(const LinesDrawing& drawing) {
  double width = SheetBuilder::text_box("BL", {}, {0.0, 0.0}).half.x() * 2.0;
  // Those that stand beside a grid; stations are below it.
  for (const auto* family : {&drawing.waterlines, &drawing.buttocks}) {
    for (const NamedCurves& member : *family) {
      const OrientedBox box = SheetBuilder::text_box(member.label, {}, {0.0, 0.0});
      width = std::max(width, 2.0 * box.half.x());
    }
  }
  // A little more, for labels as wide as the column to be within the view though rounded.
  return width + 0.1;
}

void check_density(std::size_t count, double extent, const std::string& kind,
                   const LinesSheet& sheet, const LinesDrawing& drawing) {
  const double room = extent * sheet.profile.scale;
  // One or two have no average distance to speak of.
  if (count < 3 || room / static_cast<double>(count) >= kNearestLines) return;
  std::string message = std::to_string(count) + " " + kind;
  message += " would run together at " + scale_text(sheet.scale_denominator);
  message += " on " + drawing.paper.name;
  throw std::invalid_argument(message + ": space them wider or take larger paper");
}

void check_densities(const LinesSheet& sheet, const LinesDrawing& drawing,
                     const HullExtents& extents) {
  const double length = extents.fore - extents.aft;
  check_density(drawing.stations.size(), length, "stations", sheet, drawing);
  check_density(drawing.waterlines.size(), extents.top - extents.bottom, "waterlines", sheet,
                drawing);
  check_density(drawing.buttocks.size(), extents.breadth, "buttocks", sheet, drawing);
}

std::string extension_of(const std::string& path) {
  const auto dot = path.find_last_of('.');
  std::string extension = dot == path.npos ? "" : path.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

LinesSheet lay_out_lines(const LinesDrawing& drawing) {
  const PlanViews& views = drawing.views;
  if (!views.profile && !views.half_breadth && !views.body_plan) {
    throw std::invalid_argument("A lines plan has a view at least: choose one.");
  }
  const HullExtents extents = hull_extents(drawing);
  LinesSheet sheet =
      choose_layout({extents, drawing.paper, drawing.scale_denominator, label_column(drawing),
                     drawing.frame_spacing || drawing.frames, title_block_size(drawing),
                     offsets_block_sizes(drawing), views});
  // Only with the layout is the scale known.
  check_densities(sheet, drawing, extents);
  sheet.title = drawing.title;
  SheetBuilder builder(sheet);
  builder.draw(pens::kFrame, outline_of(sheet.frame));
  draw_title_block(builder, sheet, drawing);
  if (views.profile) draw_profile(builder, sheet.profile, drawing, extents);
  if (views.half_breadth) draw_half_breadth(builder, sheet.half_breadth, drawing, extents);
  if (views.body_plan) draw_body_plan(builder, sheet.body_plan, drawing, extents);
  if (!sheet.table.isEmpty()) {
    draw_offsets_block(builder, sheet.table, drawing, sheet.table_form);
  }
  // The builder drew on a copy of the Sheet alone; frame, views and scale are still here.
  static_cast<Sheet&>(sheet) = std::move(builder).finish();
  return sheet;
}

bool is_dxf_path(const std::string& path) { return extension_of(path) == ".dxf"; }

void check_lines_path(const std::string& path) {
  if (is_dxf_path(path)) return;
  try {
    check_drawing_path(path);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument("A lines plan cannot be written to \"" + path +
                                "\": the name must end in .pdf, .svg, .png or .dxf");
  }
}

void write_lines_drawing(const LinesDrawing& drawing, const std::string& path) {
  check_lines_path(path);
  write_lines_sheet(lay_out_lines(drawing), drawing, path);
}

void write_lines_sheet(const LinesSheet& sheet, const LinesDrawing& drawing,
                       const std::string& path) {
  if (is_dxf_path(path)) {
    write_lines_dxf(sheet, drawing.dxf_unit, path);
  } else {
    write_sheet(sheet, path);
  }
}

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_drawing.h"

#include <algorithm>
#include <utility>

#include "drawing/canvas.h"
#include "drawing/lines_views.h"
#include "drawing/plan_layout.h"
#include "drawing/sheet_builder.h"
#include "drawing/title_block.h"

namespace hull {

namespace {

// The width of the widest label beside a grid.
double label_column(const LinesDrawing& drawing) {
  double width = SheetBuilder::text_box("BL", {}, {0.0, 0.0}).half.x() * 2.0;
  for (const auto* family : {&drawing.waterlines, &drawing.buttocks}) {
    for (const NamedCurves& member : *family) {
      const OrientedBox box = SheetBuilder::text_box(member.label, {}, {0.0, 0.0});
      width = std::max(width, 2.0 * box.half.x());
    }
  }
  return width + 0.1;
}

}  // namespace

LinesSheet lay_out_lines(const LinesDrawing& drawing) {
  const HullExtents extents = hull_extents(drawing);
  LinesSheet sheet =
      choose_layout(extents, drawing.paper, label_column(drawing), title_block_size(drawing));
  sheet.title = drawing.title;
  SheetBuilder builder(sheet);
  builder.draw(pens::kFrame, outline_of(sheet.frame));
  draw_title_block(builder, sheet, drawing);
  draw_profile(builder, sheet.profile, drawing, extents);
  draw_half_breadth(builder, sheet.half_breadth, drawing, extents);
  draw_body_plan(builder, sheet.body_plan, drawing, extents);
  static_cast<Sheet&>(sheet) = std::move(builder).finish();
  return sheet;
}

void write_lines_drawing(const LinesDrawing& drawing, const std::string& path) {
  check_drawing_path(path);
  write_sheet(lay_out_lines(drawing), path);
}

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/frame_scale.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "drawing/lines_plan/plan_layout.h"

namespace hull::drawing {

namespace {

constexpr double kNearestMarks = 0.5;    // mm
constexpr double kNearestNumbers = 9.0;  // mm, wider than any number
constexpr double kNumberSize = 2.2;

// Every so many frames have a number.
long numbered_every(double mm_per_frame) {
  for (long power = 1; power < 1000000; power *= 10) {
    for (const long step : {1, 2, 5}) {
      if (step * power * mm_per_frame >= kNearestNumbers) return step * power;
    }
  }
  return 1000000;
}

}  // namespace

void draw_frame_scale(SheetBuilder& builder, const View& view, const GridBox& grid,
                      const LinesDrawing& drawing, const HullExtents& extents) {
  const double spacing = *drawing.frame_spacing;
  const double y = grid.max().y() + kLabelRow + 1.0;
  builder.draw(pens::kFrameScale,
               {{view.to_page(extents.aft, 0.0).x(), y}, {view.to_page(extents.fore, 0.0).x(), y}});
  const long every = numbered_every(view.scale * spacing);
  const bool marks_all = view.scale * spacing >= kNearestMarks;
  const long first = std::lround(std::ceil(extents.aft / spacing - 1e-6));
  const long last = std::lround(std::floor(extents.fore / spacing + 1e-6));
  const long step = marks_all ? 1 : every;
  // From a multiple of the step on, so that the numbers are multiples of theirs.
  for (long frame = static_cast<long>(std::floor(static_cast<double>(first) / step)) * step;
       frame <= last; frame += step) {
    if (frame < first) continue;
    const double x = view.to_page(frame * spacing, 0.0).x();
    const bool numbered = frame % every == 0;
    const double length = numbered ? 1.6 : every >= 10 && frame % (every / 2) == 0 ? 1.2 : 0.8;
    builder.draw(pens::kFrameScale, {{x, y}, {x, y + length}});
    if (!numbered) continue;
    const TextStyle style{.size = kNumberSize, .ink = inks::kGrey};
    const std::string number = std::to_string(frame);
    const OrientedBox box = SheetBuilder::text_box(number, style, {x, y + 3.3});
    if (builder.has_room(box, 0.2, view.bounds)) builder.put_text(number, style, box);
  }
  const auto put = [&](const std::string& text, double x, Align align) {
    const TextStyle style{.size = kNumberSize, .ink = inks::kGrey};
    const OrientedBox box = SheetBuilder::text_box(text, style, {x, y + 1.0}, align);
    if (builder.has_room(box, 0.2, view.bounds)) builder.put_text(text, style, box);
  };
  put("Fr.", grid.min().x() - kColumnGap, Align::kRight);
  char apart[32];
  std::snprintf(apart, sizeof apart, "%.6g mm", 1000.0 * spacing);
  put(apart, grid.max().x() + kColumnGap, Align::kLeft);
}

}  // namespace hull::drawing

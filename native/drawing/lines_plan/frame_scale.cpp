// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/frame_scale.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/lines_plan/plan_layout.h"

namespace hull::drawing {

namespace {

constexpr double kNearestMarks = 0.5;    // mm
constexpr double kNearestNumbers = 9.0;  // mm, wider than any number
constexpr double kMarkNumberSize = 2.2;

// Every so many frames have a number.
// 1, 2 or 5 times a power of ten.
long numbered_every(double mm_per_frame) {
  for (long power = 1; power < 1000000; power *= 10) {
    for (const long step : {1, 2, 5}) {
      if (step * power * mm_per_frame >= kNearestNumbers) return step * power;
    }
  }
  return 1000000;
}

struct FrameMark {
  long number;
  double x;  // m
  std::string name;
};

// From aft or from forward, as numbers rise, within the hull.
std::vector<FrameMark> marks_of(const LinesDrawing& drawing, const HullExtents& extents) {
  std::vector<FrameMark> marks;
  if (drawing.frames) {
    const PlanFrames& frames = *drawing.frames;
    // A frame at the very end of the hull is one, though rounded.
    const double slack = 1e-6 * (extents.fore - extents.aft);
    for (std::size_t i = 0; i < frames.positions.size(); ++i) {
      const double x = frames.positions[i];
      if (x < extents.aft - slack || x > extents.fore + slack) continue;
      marks.push_back({frames.first + static_cast<long>(i), x, frames.names[i]});
    }
    return marks;
  }
  const double spacing = *drawing.frame_spacing;
  // Frame 0 is at x = 0, whatever the hull's after end is; a frame at an end counts though rounded.
  const long first = std::lround(std::ceil(extents.aft / spacing - 1e-6));
  const long last = std::lround(std::floor(extents.fore / spacing + 1e-6));
  for (long frame = first; frame <= last; ++frame) {
    marks.push_back({frame, frame * spacing, std::to_string(frame)});
  }
  return marks;
}

// (least, largest) distance of frames, m.
std::pair<double, double> spacings_of(const LinesDrawing& drawing) {
  if (!drawing.frames) return {*drawing.frame_spacing, *drawing.frame_spacing};
  const std::vector<double>& x = drawing.frames->positions;
  std::pair<double, double> found(std::abs(x[1] - x[0]), 0.0);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double apart = std::abs(x[i] - x[i - 1]);
    found = {std::min(found.first, apart), std::max(found.second, apart)};
  }
  return found;
}

}  // namespace

void draw_frame_scale(SheetBuilder& builder, const View& view, const GridBox& grid,
                      const LinesDrawing& drawing, const HullExtents& extents) {
  const auto [least, largest] = spacings_of(drawing);
  const double y = grid.max().y() + kLabelRow + 1.0;
  builder.draw(pens::kFrameScale,
               {{view.to_page(extents.aft, 0.0).x(), y}, {view.to_page(extents.fore, 0.0).x(), y}});
  const long every = numbered_every(view.scale * least);
  const bool marks_all = view.scale * least >= kNearestMarks;
  for (const FrameMark& mark : marks_of(drawing, extents)) {
    // Multiples, wherever the frames begin; of negative ones, abaft frame 0, too.
    const bool numbered = mark.number % every == 0;
    if (!numbered && !marks_all) continue;
    const double x = view.to_page(mark.x, 0.0).x();
    const double length = numbered                                        ? 1.6
                          : every >= 10 && mark.number % (every / 2) == 0 ? 1.2
                                                                          : 0.8;
    builder.draw(pens::kFrameScale, {{x, y}, {x, y + length}});
    if (!numbered) continue;
    const TextStyle style{.size = kMarkNumberSize, .ink = inks::kGrey};
    const OrientedBox box = SheetBuilder::text_box(mark.name, style, {x, y + 3.3});
    if (builder.has_room(box, 0.2, view.bounds)) builder.put_text(mark.name, style, box);
  }
  const auto put = [&](const std::string& text, double x, Align align) {
    const TextStyle style{.size = kMarkNumberSize, .ink = inks::kGrey};
    const OrientedBox box = SheetBuilder::text_box(text, style, {x, y + 1.0}, align);
    if (builder.has_room(box, 0.2, view.bounds)) builder.put_text(text, style, box);
  };
  put("Fr.", grid.min().x() - kColumnGap, Align::kRight);
  if (largest - least > 1e-9 * largest) return;  // it is not one
  put(spacing_text(least, drawing.unit), grid.max().x() + kColumnGap, Align::kLeft);
}

}  // namespace hull::drawing

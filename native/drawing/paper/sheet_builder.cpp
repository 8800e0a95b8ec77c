// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/sheet_builder.h"

#include <algorithm>
#include <cmath>

#include "drawing/paper/text_meter.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

// Line breaks, tabs and other controls have no glyph: a blank instead.
std::string without_controls(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return text;
}

}  // namespace

PagePath outline_of(const AlignedBox2d& box) {
  const Vector2d &low = box.min(), &high = box.max();
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
}

void SheetBuilder::draw(const Pen& pen, PagePath points) {
  if (points.size() > 1) sheet_.strokes.push_back({pen, std::move(points), std::nullopt});
}

int SheetBuilder::draw_curve(const Pen& pen, PagePath points, std::optional<PageSpline> spline) {
  // Numbered also where nothing is drawn: numbers of curves and of obstacles stay the same.
  const int number = placer_.add_curve(points);
  if (points.size() > 1) sheet_.strokes.push_back({pen, std::move(points), std::move(spline)});
  return number;
}

OrientedBox SheetBuilder::text_box(const std::string& text, const TextStyle& style,
                                   const Vector2d& position, Align align, double angle) {
  const TextSize size = text_size(without_controls(text), style.size, style.bold);
  const Vector2d half(0.5 * size.width, 0.5 * (size.ascent + size.descent));
  const Vector2d along(std::cos(angle), std::sin(angle));
  // On the page y runs down, so this is below the text.
  const Vector2d down(-along.y(), along.x());
  const double shift = align == Align::kLeft ? half.x() : align == Align::kRight ? -half.x() : 0.0;
  // Letters that hang below the baseline do not lift the others: texts in a row stay in line.
  return {position + shift * along + 0.5 * size.descent * down, half, angle};
}

void SheetBuilder::put_text(const std::string& text, const TextStyle& style,
                            const OrientedBox& box) {
  if (text.empty()) return;
  // Whatever comes later keeps clear of it.
  placer_.add_box(box);
  const std::string shown = without_controls(text);
  const double descent = text_size(shown, style.size, style.bold).descent;
  sheet_.labels.push_back({shown, style.size, style.bold, style.ink, style.knockout, descent, box});
}

bool SheetBuilder::has_room(const OrientedBox& box, double clearance, const AlignedBox2d& bounds,
                            int own_curve) const {
  // Without the clearance: a label may touch the bounds.
  for (const Vector2d& corner : box.corners()) {
    if (!bounds.contains(corner)) return false;
  }
  return placer_.is_free(box.grown(clearance), own_curve);
}

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/title_block.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "drawing/lines_plan/plan_layout.h"
#include "drawing/paper/text_meter.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kWidth = 124.0;
constexpr double kPadding = 3.0;
constexpr double kTitleRow = 17.0;
constexpr double kRow = 4.6;
constexpr double kScaleRow = 13.0;
constexpr double kLongestBar = 70.0;
constexpr std::size_t kRowsOfOneColumn = 3;

std::size_t columns(std::size_t count) { return count > kRowsOfOneColumn ? 2 : 1; }

std::size_t rows(std::size_t count) { return (count + columns(count) - 1) / columns(count); }

double table_height(std::size_t count) { return count == 0 ? 0.0 : rows(count) * kRow + 2.0 * 1.2; }

void put(SheetBuilder& builder, const std::string& text, TextStyle style, const Vector2d& position,
         Align align, double width) {
  const FittedText fitted = fit_text(text, style.size, style.bold, width);
  style.size = fitted.size;
  builder.put_text(fitted.text, style, SheetBuilder::text_box(fitted.text, style, position, align));
}

void draw_heading(SheetBuilder& builder, const AlignedBox2d& box, const LinesSheet& sheet,
                  const LinesDrawing& drawing) {
  const double left = box.min().x() + kPadding;
  const double right = box.max().x() - kPadding;
  const double width = right - left;
  put(builder, drawing.title, {.size = 5.0, .bold = true}, {left, box.min().y() + 6.0},
      Align::kLeft, width);
  put(builder, "Lines plan", {.size = 3.2}, {left, box.min().y() + 12.5}, Align::kLeft,
      0.4 * width);
  const std::string scale = scale_text(sheet.scale_denominator) + " on " + drawing.paper.name;
  put(builder, scale, {.size = 3.2, .bold = true}, {right, box.min().y() + 12.5}, Align::kRight,
      0.5 * width);
}

void draw_table(SheetBuilder& builder, const AlignedBox2d& box,
                const std::vector<Particular>& particulars) {
  const std::size_t row_count = rows(particulars.size());
  const double column_width = box.sizes().x() / columns(particulars.size());
  for (std::size_t i = 0; i < particulars.size(); ++i) {
    // Down the first column, then down the second.
    const double left = box.min().x() + (i / row_count) * column_width + kPadding;
    const double right = left + column_width - 2.0 * kPadding;
    const double y = box.min().y() + 1.2 + kRow * (0.5 + i % row_count);
    const double width = right - left;
    // The value is what the row is for: it gets its room first.
    const FittedText value = fit_text(particulars[i].value, kLabelSize, false, 0.6 * width);
    const double taken = text_size(value.text, value.size, false).width;
    // The same as measured: put() fits the text anew.
    put(builder, particulars[i].value, {}, {right, y}, Align::kRight, 0.6 * width);
    put(builder, particulars[i].name, {.ink = inks::kGrey}, {left, y}, Align::kLeft,
        width - taken - 2.0);
  }
}

// The length of one of the bar's five parts: 1, 2 or 5 times a power of ten.
double bar_part(double mm_per_unit) {
  // In units of length, so that the numbers along the bar are round ones.
  const double most = kLongestBar / 5.0 / mm_per_unit;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  // The longest that the bar has room for.
  for (const double mantissa : {5.0, 2.0}) {
    if (mantissa * power <= most) return mantissa * power;
  }
  return power;
}

void draw_scale_bar(SheetBuilder& builder, const AlignedBox2d& box, double scale_denominator,
                    LengthUnit unit) {
  const double mm_per_unit = 1000.0 * metres_of(unit) / scale_denominator;
  const double part = bar_part(mm_per_unit);
  const double step = part * mm_per_unit;
  const Vector2d corner(box.min().x() + kPadding + 2.0, box.min().y() + 7.0);
  const double height = 1.6;
  for (int i = 0; i < 5; ++i) {
    const Vector2d low = corner + Vector2d(i * step, 0.0);
    const Vector2d high = low + Vector2d(step, height);
    const PagePath part_outline = outline_of({low, high});
    if (i % 2 == 0) builder.fill(inks::kBlack, part_outline);
    builder.draw(pens::kTable, part_outline);
  }
  for (int i = 0; i <= 5; ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", i * part);
    const TextStyle style{.size = 2.4};
    // By the number alone, without its unit.
    const double half = 0.5 * text_size(text, style.size, false).width;
    // The unit hangs over to the right, so that the number stays above its mark.
    const std::string shown = i == 5 ? std::string(text) + " " + symbol_of(unit) : text;
    const Vector2d left = corner + Vector2d(i * step - half, -2.2);
    builder.put_text(shown, style, SheetBuilder::text_box(shown, style, left, Align::kLeft));
  }
  put(builder, "Lengths in " + plural_of(unit), {.size = 2.4, .ink = inks::kGrey},
      {box.max().x() - kPadding, corner.y() + 0.5 * height}, Align::kRight, 30.0);
}

}  // namespace

Vector2d title_block_size(const LinesDrawing& drawing) {
  const auto check = [](std::size_t count, std::size_t most, const char* kind) {
    if (count <= most) return;
    std::string message = "A lines plan has room for " + std::to_string(most);
    message += " " + std::string(kind) + ", not " + std::to_string(count);
    throw std::invalid_argument(message);
  };
  check(drawing.particulars.size(), kMostParticulars, "particulars");
  check(drawing.title_rows.size(), kMostTitleRows, "rows below the title");
  return {kWidth, kTitleRow + table_height(drawing.title_rows.size()) +
                      table_height(drawing.particulars.size()) + kScaleRow};
}

void draw_title_block(SheetBuilder& builder, const LinesSheet& sheet, const LinesDrawing& drawing) {
  const AlignedBox2d& box = sheet.title_block;
  const double left = box.min().x(), right = box.max().x();
  const double top = box.min().y(), bottom = box.max().y();
  // The other two sides are the sheet's frame.
  builder.draw(pens::kFrame, {{left, bottom}, {left, top}, {right, top}});
  draw_heading(builder, box, sheet, drawing);
  double y = top + kTitleRow;
  builder.draw(pens::kTable, {{left, y}, {right, y}});
  for (const auto* rows_of : {&drawing.title_rows, &drawing.particulars}) {
    if (rows_of->empty()) continue;
    const double end = y + table_height(rows_of->size());
    draw_table(builder, {Vector2d(left, y), Vector2d(right, end)}, *rows_of);
    builder.draw(pens::kTable, {{left, end}, {right, end}});
    y = end;
  }
  draw_scale_bar(builder, {Vector2d(left, y), Vector2d(right, bottom)}, sheet.scale_denominator,
                 drawing.unit);
}

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_legend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/paper/text_meter.h"
#include "drawing/plots/plot_marks.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kSize = 2.5;
constexpr double kColumnSpace = 5.0;
// To how much of their size texts are made smaller for a further column, rather than left out.
constexpr double kLeastShare = 0.8;

// share: of the text's usual size.
double entry_width(const LegendEntry& entry, double share = 1.0) {
  return entry.width + kSignGap + share * text_size(entry.text, kSize, false).width;
}

double widest_entry(const std::vector<LegendEntry>& entries, double share = 1.0) {
  double widest = 0.0;
  for (const LegendEntry& entry : entries) widest = std::max(widest, entry_width(entry, share));
  return widest;
}

int columns_of(double column_width, double width) {
  return static_cast<int>((width + kColumnSpace) / (column_width + kColumnSpace));
}

void put(SheetBuilder& builder, const std::string& text, const Vector2d& place, double width) {
  const FittedText fitted = fit_text(text, kSize, false, width);
  const TextStyle style{.size = fitted.size};
  builder.put_text(fitted.text, style,
                   SheetBuilder::text_box(fitted.text, style, place, Align::kLeft));
}

}  // namespace

void draw_sign(SheetBuilder& builder, const LegendEntry& entry, const Vector2d& start) {
  const Vector2d end = start + Vector2d(entry.width, 0.0);
  switch (entry.sign) {
    case LegendSign::kLine:
      builder.draw(entry.pen, {start, end});
      break;
    case LegendSign::kDot:
      builder.fill(entry.pen.colour, dot_outline(0.5 * (start + end)));
      break;
    case LegendSign::kSwatch:
      builder.fill(entry.pen.colour,
                   outline_of({start - Vector2d(0.0, 1.2), end + Vector2d(0.0, 1.2)}));
      break;
    case LegendSign::kBar:
      for (const Vector2d& tip : {start, end}) {
        builder.draw(pens::kBaseline, {tip - Vector2d(0.0, 0.9), tip + Vector2d(0.0, 0.9)});
      }
      builder.draw(pens::kBaseline, {start, end});
      break;
  }
}

PlotLegend::PlotLegend(std::vector<LegendEntry> entries, double width, int most_rows)
    : entries_(std::move(entries)), column_width_(width) {
  if (entries_.empty()) return;
  const double widest = widest_entry(entries_);
  const int count = static_cast<int>(entries_.size());
  columns_ = std::clamp(columns_of(widest, width), 1, count);
  if (columns_ * most_rows < count) {
    columns_ = std::clamp(columns_of(widest_entry(entries_, kLeastShare), width), columns_, count);
  }
  rows_ = (count + columns_ - 1) / columns_;
  if (rows_ > most_rows) {
    rows_ = most_rows;
    const std::size_t shown = static_cast<std::size_t>(rows_) * columns_ - 1;
    left_out_ = entries_.size() - shown;
    entries_.resize(shown);
  } else {
    columns_ = (count + rows_ - 1) / rows_;  // as even as the rows allow
  }
  column_width_ = columns_ > 1 ? std::min((width + kColumnSpace) / columns_ - kColumnSpace,
                                          widest + kColumnSpace)
                               : width;
}

void PlotLegend::draw(SheetBuilder& builder, const Vector2d& corner) const {
  const auto place = [&](std::size_t number) -> Vector2d {
    const double column = static_cast<double>(number / rows_);
    const double row = static_cast<double>(number % rows_);
    return corner + Vector2d(column * (column_width_ + kColumnSpace), (row + 0.5) * kLegendRow);
  };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const LegendEntry& entry = entries_[i];
    draw_sign(builder, entry, place(i));
    const double taken = entry.width + kSignGap;
    put(builder, entry.text, place(i) + Vector2d(taken, 0.0), column_width_ - taken);
  }
  if (left_out_ > 0) {
    put(builder, "… and " + std::to_string(left_out_) + " more", place(entries_.size()),
        column_width_);
  }
}

}  // namespace hull::drawing

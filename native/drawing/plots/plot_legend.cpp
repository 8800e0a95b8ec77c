// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_legend.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "drawing/paper/text_meter.h"
#include "drawing/plots/plot_marks.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kTextSize = 2.5;
constexpr double kColumnSpace = 5.0;
// To how much of their size texts are made smaller for a further column, rather than left out.
constexpr double kLeastShare = 0.8;

double text_width(const LegendEntry& entry) {
  return text_size(entry.text, kTextSize, false).width;
}

// Of the signs of an entry, and the space beside them.
double signs_width(const LegendEntry& entry) {
  double width = entry.width + kSignGap;
  for (const LegendEntry& one : entry.before) width += one.width + 2.0 * kSignGap;
  return width;
}

double texts_width(const LegendEntry& entry) {
  double width = text_width(entry);
  for (const LegendEntry& one : entry.before) width += text_width(one);
  return width;
}

// share: of the texts' usual size.
// Signs are as long as they are; only texts are made smaller.
double entry_width(const LegendEntry& entry, double share = 1.0) {
  return signs_width(entry) + share * texts_width(entry);
}

double widest_entry(std::span<const LegendEntry> entries, double share = 1.0) {
  double widest = 0.0;
  for (const LegendEntry& entry : entries) widest = std::max(widest, entry_width(entry, share));
  return widest;
}

// The widths of columns of so many rows, each as wide as its entries are at the least share.
std::vector<double> own_widths(std::span<const LegendEntry> entries, int rows) {
  std::vector<double> widths;
  // Entries run down the columns.
  for (std::size_t i = 0; i < entries.size(); i += rows) {
    const std::size_t count = std::min<std::size_t>(rows, entries.size() - i);
    widths.push_back(widest_entry(entries.subspan(i, count), kLeastShare));
  }
  return widths;
}

// ... with the rest of the width shared out; none where there is not enough.
std::vector<double> fitted_widths(std::span<const LegendEntry> entries, int rows, double width) {
  std::vector<double> widths = own_widths(entries, rows);
  const double gaps = kColumnSpace * static_cast<double>(widths.size() - 1);
  const double rest = width - gaps - std::accumulate(widths.begin(), widths.end(), 0.0);
  if (rest < 0.0) return {};
  for (double& one : widths) one += rest / static_cast<double>(widths.size());
  return widths;
}

// With one gap more on both sides of the division, as n columns have n - 1 gaps.
int columns_of(double column_width, double width) {
  return static_cast<int>((width + kColumnSpace) / (column_width + kColumnSpace));
}

void put(SheetBuilder& builder, const std::string& text, const Vector2d& place, double width) {
  const FittedText fitted = fit_text(text, kTextSize, false, width);
  const TextStyle style{.size = fitted.size};
  builder.put_text(fitted.text, style,
                   SheetBuilder::text_box(fitted.text, style, place, Align::kLeft));
}

// A whole entry in its row, with its texts equally large.
void draw_entry(SheetBuilder& builder, const LegendEntry& entry, Vector2d place, double width) {
  const double right = place.x() + width;
  const double texts = texts_width(entry);
  // The signs keep their length; the texts share what is left. The divisor is never nothing, also
  // of an entry without text.
  const double share = std::min(1.0, (width - signs_width(entry)) / std::max(texts, kTextSize));
  for (const LegendEntry& one : entry.before) {
    draw_sign(builder, one, place);
    place.x() += one.width + kSignGap;
    const double room = share * text_width(one);
    put(builder, one.text, place, room);
    place.x() += room + kSignGap;
  }
  draw_sign(builder, entry, place);
  place.x() += entry.width + kSignGap;
  put(builder, entry.text, place, right - place.x());
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
    : entries_(std::move(entries)) {
  if (entries_.empty()) return;
  const double widest = widest_entry(entries_);
  const int count = static_cast<int>(entries_.size());
  int columns = std::clamp(columns_of(widest, width), 1, count);
  // Smaller texts in narrower columns only where the usual ones would take too many rows.
  if (columns * most_rows < count) {
    columns = std::clamp(columns_of(widest_entry(entries_, kLeastShare), width), columns, count);
  }
  rows_ = (count + columns - 1) / columns;
  if (rows_ > most_rows) {
    for (rows_ = 1; rows_ <= most_rows; ++rows_) {  // the fewest rows that do
      column_widths_ = fitted_widths(entries_, rows_, width);
      if (!column_widths_.empty()) return;
    }
    rows_ = most_rows;
    // The last place is for how many are left out.
    const std::size_t shown = static_cast<std::size_t>(rows_) * columns - 1;
    left_out_ = entries_.size() - shown;
    entries_.resize(shown);
  } else {
    columns = (count + rows_ - 1) / rows_;  // as even as the rows allow
  }
  // No wider than the widest entry needs: a short legend stays together at the left.
  const double own =
      columns > 1 ? std::min((width + kColumnSpace) / columns - kColumnSpace, widest + kColumnSpace)
                  : width;
  column_widths_.assign(columns, own);
}

void PlotLegend::draw(SheetBuilder& builder, const Vector2d& corner) const {
  Vector2d place = corner;
  for (std::size_t column = 0; column < column_widths_.size(); ++column) {
    const double width = column_widths_[column];
    const std::size_t begin = column * rows_;
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
      const Vector2d at = place + Vector2d(0.0, (static_cast<double>(row) + 0.5) * kLegendRow);
      const std::size_t number = begin + row;
      if (number < entries_.size()) draw_entry(builder, entries_[number], at, width);
      if (number == entries_.size() && left_out_ > 0) {
        put(builder, "… and " + std::to_string(left_out_) + " more", at, width);
      }
    }
    place.x() += width + kColumnSpace;
  }
}

}  // namespace hull::drawing

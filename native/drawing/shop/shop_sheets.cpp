// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drawing/paper/sheet_builder.h"
#include "drawing/paper/text_meter.h"
#include "drawing/shop/shop_pens.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kMargin = 10.0;  // mm, around sheets
constexpr double kFoot = 9.0;     // below, for words
constexpr double kBeyond = 5.0;   // that lines go on beyond trimming
constexpr double kMark = 6.0;     // length of corner marks
constexpr int kMostSheets = 400;
constexpr double kHeading = 34.0;  // of the first sheet

// From true mm, y up, to the page's, y down.
struct PageMap {
  double scale;
  Vector2d low;   // of the drawing, that comes …
  Vector2d page;  // … here: a lower left corner
  Vector2d operator()(const Vector2d& p) const {
    const Vector2d off = scale * (p - low);
    return {page.x() + off.x(), page.y() - off.y()};
  }
};

AlignedBox2d box_of(const ShopDrawing& drawing) {
  AlignedBox2d box;
  for (const ShopLine& line : drawing.lines) {
    for (const Vector2d& p : line.points) box.extend(p);
  }
  return box;
}

// The part of a-b within the box, in the line's parameter (Liang and Barsky 1984).
bool clip(const AlignedBox2d& box, const Vector2d& a, const Vector2d& b, double& from, double& to) {
  from = 0.0;
  to = 1.0;
  const Vector2d way = b - a;
  for (int k = 0; k < 2; ++k) {
    const double low = box.min()[k] - a[k], high = box.max()[k] - a[k];
    if (way[k] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    from = std::max(from, std::min(low / way[k], high / way[k]));
    to = std::min(to, std::max(low / way[k], high / way[k]));
  }
  return from < to;
}

std::vector<PagePath> clipped(const PagePath& path, const AlignedBox2d& box) {
  std::vector<PagePath> parts;
  for (std::size_t i = 1; i < path.size(); ++i) {
    double from = 0.0, to = 1.0;
    if (!clip(box, path[i - 1], path[i], from, to)) continue;
    const Vector2d way = path[i] - path[i - 1];
    const Vector2d begin = path[i - 1] + from * way, end = path[i - 1] + to * way;
    // Bit for bit: an end that was not cut is the next begin.
    if (parts.empty() || parts.back().back() != begin) parts.push_back({begin});
    parts.back().push_back(to == 1.0 ? path[i] : end);
  }
  return parts;
}

void put(SheetBuilder& builder, const std::string& text, const TextStyle& style, const Vector2d& at,
         Align align = Align::kCentre, double angle = 0.0) {
  builder.put_text(text, style, SheetBuilder::text_box(text, style, at, align, angle));
}

void draw_content(SheetBuilder& builder, const ShopDrawing& drawing, const PageMap& map,
                  const AlignedBox2d& window, double text_scale) {
  for (const ShopLine& line : drawing.lines) {
    PagePath path;
    for (const Vector2d& p : line.points) path.push_back(map(p));
    const Pen pen = shop_pen(line.layer).pen;
    for (PagePath& part : clipped(path, window)) builder.draw(pen, std::move(part));
  }
  for (const ShopText& text : drawing.texts) {
    const TextStyle style{.size = text_scale * text.size, .knockout = true};
    // Smaller letters would be specks.
    if (style.size < 0.9) continue;
    // Up for one who reads the text; on the page y runs down.
    const Vector2d up(-std::sin(text.angle), -std::cos(text.angle));
    const Vector2d at = map(text.position) + text_scale * text.lift * up;
    if (!window.contains(at)) continue;
    put(builder, text.text, style, at, Align::kCentre, -text.angle);
  }
}

std::string sheet_name(int row, int column) {
  std::string name;
  for (int r = row + 1; r > 0; r = (r - 1) / 26) {
    name.insert(name.begin(), static_cast<char>('A' + (r - 1) % 26));
  }
  return name + std::to_string(column + 1);
}

// How the drawing falls on sheets.
struct Division {
  PaperSize paper;
  double scale;
  AlignedBox2d box;
  Vector2d tile;  // mm on paper
  int columns, rows;
};

void check(const ShopDrawing& drawing, double scale) {
  if (drawing.lines.empty()) {
    throw std::invalid_argument("The drawing \"" + drawing.title + "\" has no lines.");
  }
  if (!(scale > 0.0 && scale <= 10.0)) {
    throw std::invalid_argument("The scale of shop drawings must be above 0 and at most 10:1.");
  }
}

Division divide(const ShopDrawing& drawing, const PaperSize& paper, double scale) {
  check(drawing, scale);
  Division d{paper, scale, box_of(drawing), {}, 0, 0};
  // A line's own width stays on the sheet.
  const Vector2d pad = Vector2d::Constant(3.0 / scale);
  d.box = {d.box.min() - pad, d.box.max() + pad};
  d.tile = {paper.width - 2.0 * (kMargin + kBeyond),
            paper.height - 2.0 * (kMargin + kBeyond) - kFoot};
  const Vector2d count = (scale * d.box.sizes()).cwiseQuotient(d.tile);
  const Vector2d whole = (count.array() - 1e-9).ceil().max(1.0);
  // As doubles: an int may not hold as many. So that what is no number fails too.
  if (!(count.prod() <= kMostSheets && whole.prod() <= kMostSheets)) {
    throw std::invalid_argument("The drawing \"" + drawing.title + "\" would take more than " +
                                std::to_string(kMostSheets) + " sheets of " + paper.name +
                                ": take larger paper or a smaller scale.");
  }
  return {paper, scale, d.box, d.tile, static_cast<int>(whole.x()), static_cast<int>(whole.y())};
}

std::string scale_words(double scale) {
  char text[40];
  if (scale <= 1.0) {
    std::snprintf(text, sizeof text, "1:%.4g", 1.0 / scale);
  } else {
    std::snprintf(text, sizeof text, "%.4g:1", scale);
  }
  return text;
}

// Where sheets are trimmed.
void draw_corner_marks(SheetBuilder& builder, const AlignedBox2d& box) {
  for (const double x : {box.min().x(), box.max().x()}) {
    for (const double y : {box.min().y(), box.max().y()}) {
      builder.draw(pens::kTable, {{x - kMark, y}, {x + kMark, y}});
      builder.draw(pens::kTable, {{x, y - kMark}, {x, y + kMark}});
    }
  }
}

// 100 mm to measure, as printers scale.
void draw_check(SheetBuilder& builder, const Vector2d& right_end) {
  const Vector2d left = right_end - Vector2d(100.0, 0.0);
  builder.draw(pens::kTable, {left, right_end});
  for (int i = 0; i <= 10; ++i) {
    const Vector2d at = left + Vector2d(10.0 * i, 0.0);
    builder.draw(pens::kTable, {at, at - Vector2d(0.0, i % 5 == 0 ? 2.2 : 1.4)});
  }
  put(builder, "100 mm on paper", {.size = 2.2, .ink = inks::kGrey}, left - Vector2d(2.0, 0.8),
      Align::kRight);
}

Sheet tile_sheet(const ShopDrawing& drawing, const Division& d, int row, int column) {
  SheetBuilder builder(Sheet{drawing.title, d.paper.width, d.paper.height, {}, {}, {}, {}});
  const Vector2d corner(kMargin + kBeyond, kMargin + kBeyond + d.tile.y());
  const AlignedBox2d tile(Vector2d(corner.x(), corner.y() - d.tile.y()),
                          Vector2d(corner.x() + d.tile.x(), corner.y()));
  const Vector2d low = d.box.min() + Vector2d(column * d.tile.x(), row * d.tile.y()) / d.scale;
  const PageMap map{d.scale, low, corner};
  const Vector2d beyond = Vector2d::Constant(kBeyond);
  draw_content(builder, drawing, map, {tile.min() - beyond, tile.max() + beyond}, 1.0);
  draw_corner_marks(builder, tile);
  const double foot = d.paper.height - kMargin + 2.0;
  put(builder, drawing.title + " · " + scale_words(d.scale) + " · sheet " + sheet_name(row, column),
      {.size = 3.2, .bold = true}, {kMargin, foot - 1.0}, Align::kLeft);
  draw_check(builder, {d.paper.width - kMargin, foot});
  return std::move(builder).finish();
}

void draw_heading(SheetBuilder& builder, const ShopDrawing& drawing, const Division& d) {
  const double left = kMargin + 3.0, right = d.paper.width - kMargin - 3.0;
  const FittedText title = fit_text(drawing.title, 6.0, true, 0.6 * (right - left));
  put(builder, title.text, {.size = title.size, .bold = true}, {left, kMargin + 7.0}, Align::kLeft);
  const int count = d.columns * d.rows;
  const std::string many = count == 1 ? "" : std::to_string(count) + " sheets of ";
  const std::string sheets = scale_words(d.scale) + " on " + many + d.paper.name;
  put(builder, sheets, {.size = 3.5, .bold = true}, {right, kMargin + 7.0}, Align::kRight);
  // Rows in columns of four.
  const double width = (right - left) / 4.0;
  for (std::size_t i = 0; i < drawing.rows.size() && i < 16; ++i) {
    const double x = left + static_cast<double>(i / 4) * width;
    const double y = kMargin + 14.5 + 4.8 * static_cast<double>(i % 4);
    const FittedText value = fit_text(drawing.rows[i].second, kLabelSize, false, 0.5 * width);
    put(builder, drawing.rows[i].first, {.ink = inks::kGrey}, {x, y}, Align::kLeft);
    put(builder, value.text, {.size = value.size}, {x + width - 6.0, y}, Align::kRight);
  }
}

// Room for the drawing below the heading.
Vector2d room_on(const PaperSize& paper) {
  return {paper.width - 2.0 * kMargin - 16.0, paper.height - 2.0 * kMargin - kHeading - 16.0};
}

Sheet overview(const ShopDrawing& drawing, const Division& d) {
  SheetBuilder builder(Sheet{drawing.title, d.paper.width, d.paper.height, {}, {}, {}, {}});
  const AlignedBox2d frame(Vector2d::Constant(kMargin),
                           Vector2d(d.paper.width - kMargin, d.paper.height - kMargin));
  builder.draw(pens::kFrame, outline_of(frame));
  draw_heading(builder, drawing, d);
  const double top = kMargin + kHeading;
  builder.draw(pens::kTable, {{kMargin, top}, {frame.max().x(), top}});
  const Vector2d room = room_on(d.paper);
  const Vector2d whole = Vector2d(d.columns * d.tile.x(), d.rows * d.tile.y()) / d.scale;
  const double fit = room.cwiseQuotient(whole).minCoeff();
  const double scale = std::min(fit, d.scale);
  const Vector2d spare = room - scale * whole;
  const PageMap map{scale,
                    d.box.min(),
                    {kMargin + 8.0 + 0.5 * spare.x(), frame.max().y() - 8.0 - 0.5 * spare.y()}};
  const auto grid_point = [&](int column, int row) {
    return map(d.box.min() + Vector2d(column * d.tile.x(), row * d.tile.y()) / d.scale);
  };
  const bool divided = d.columns * d.rows > 1;
  for (int c = 0; divided && c <= d.columns; ++c) {
    builder.draw(pens::kGrid, {grid_point(c, 0), grid_point(c, d.rows)});
  }
  for (int r = 0; divided && r <= d.rows; ++r) {
    builder.draw(pens::kGrid, {grid_point(0, r), grid_point(d.columns, r)});
  }
  draw_content(builder, drawing, map, frame, std::clamp(3.0 * scale, 0.32, 0.8));
  for (int r = 0; divided && r < d.rows; ++r) {
    for (int c = 0; c < d.columns; ++c) {
      const Vector2d at = grid_point(c, r + 1) + Vector2d(1.0, 2.5);
      put(builder, sheet_name(r, c), {.size = 2.4, .ink = inks::kGrey}, at, Align::kLeft);
    }
  }
  return std::move(builder).finish();
}

}  // namespace

Sheet shop_sheet(const ShopDrawing& drawing, double scale, double largest) {
  check(drawing, scale);
  AlignedBox2d box = box_of(drawing);
  const Vector2d pad = Vector2d::Constant(kMargin / scale);
  box = {box.min() - pad, box.max() + pad};
  const Vector2d page = scale * box.sizes();
  if (page.maxCoeff() > largest) {
    throw std::invalid_argument("The drawing \"" + drawing.title + "\" is longer than " +
                                std::to_string(static_cast<int>(largest / 1000.0)) +
                                " m on paper: take a smaller scale, or PDF or DXF.");
  }
  SheetBuilder builder(Sheet{drawing.title, page.x(), page.y(), {}, {}, {}, {}});
  draw_content(builder, drawing, {scale, box.min(), {0.0, page.y()}}, {Vector2d::Zero(), page},
               1.0);
  return std::move(builder).finish();
}

Sheet shop_page(const ShopDrawing& drawing, const PaperSize& paper) {
  check(drawing, 1.0);
  const AlignedBox2d box = box_of(drawing);
  const Vector2d size = box.sizes().cwiseMax(1e-9);
  const double fit = room_on(paper).cwiseQuotient(size).minCoeff();
  // 1, 2, 2.5 or 5 times a power of ten.
  // Enlargements are not usual in the shop: 1:1 at most.
  double scale = 1.0;
  for (double power = 1.0; power < 1e9 && scale > fit; power *= 10.0) {
    for (const double step : {1.0, 2.0, 2.5, 5.0}) {
      if (scale > fit) scale = 1.0 / (power * step);
    }
  }
  return overview(drawing, {paper, scale, box, scale * size, 1, 1});
}

std::vector<Sheet> shop_sheets(const ShopDrawing& drawing, const PaperSize& paper, double scale) {
  const Division d = divide(drawing, paper, scale);
  std::vector<Sheet> sheets{overview(drawing, d)};
  for (int row = 0; row < d.rows; ++row) {
    for (int column = 0; column < d.columns; ++column) {
      sheets.push_back(tile_sheet(drawing, d, row, column));
    }
  }
  return sheets;
}

}  // namespace hull::drawing

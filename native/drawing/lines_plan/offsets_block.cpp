// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/offsets_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "drawing/paper/text_meter.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kCellPadding = 0.9;  // mm, left and right of a number
constexpr char kKnuckleMark[] = "K";
constexpr char kLegend[] = "K on a knuckle";

// The ems that the table's letters may have, mm: the largest that leave the hull its scale.
constexpr std::array kLetterSizes = {2.8, 2.4, 2.0, 1.7};

// One kind of offset of all stations: a column of the upright form, a row of the lying one.
struct OffsetLine {
  std::string head;
  std::vector<std::string> values;  // one a station
  std::vector<bool> on_knuckle;
};

struct OffsetGroup {
  std::string name;
  std::vector<OffsetLine> lines;
};

std::string title_of(const LinesDrawing& drawing) {
  return "Table of offsets, moulded, " + offsets_unit(drawing.unit);
}

OffsetLine line_of(const std::string& head, std::size_t count, LengthUnit unit,
                   const std::function<analysis::Offset(std::size_t)>& offset) {
  OffsetLine line{head, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const analysis::Offset found = offset(i);
    line.values.push_back(offset_text(found.value, unit));
    line.on_knuckle.push_back(found.on_knuckle);
  }
  return line;
}

std::vector<OffsetGroup> groups_of(const LinesDrawing& drawing) {
  const analysis::OffsetTable& table = *drawing.offsets;
  const std::size_t count = table.stations.size();
  const LengthUnit unit = drawing.unit;
  const auto head_of = [unit](const NamedCurves& line) { return without_unit(line.label, unit); };
  std::vector<OffsetGroup> groups;
  OffsetGroup& waterlines =
      groups.emplace_back(OffsetGroup{"Half-breadths, WL " + symbol_of(unit), {}});
  for (std::size_t j = 0; j < table.waterlines.size(); ++j) {
    waterlines.lines.push_back(line_of(head_of(drawing.waterlines[j]), count, unit,
                                       [&](std::size_t i) { return table.half_breadth(i, j); }));
  }
  OffsetGroup& buttocks =
      groups.emplace_back(OffsetGroup{"Heights, buttock " + symbol_of(unit), {}});
  // The centre line comes before the buttocks that are drawn.
  // One, or none in a table that has no centre line.
  const std::size_t before = table.buttocks.size() - drawing.buttocks.size();
  for (std::size_t j = 0; j < table.buttocks.size(); ++j) {
    const std::string head = j < before ? "CL" : head_of(drawing.buttocks[j - before]);
    buttocks.lines.push_back(
        line_of(head, count, unit, [&](std::size_t i) { return table.height(i, j); }));
  }
  for (const analysis::FeatureOffsets& feature : table.features) {
    OffsetGroup& group = groups.emplace_back(OffsetGroup{feature.name, {}});
    group.lines.push_back(line_of("y", count, unit, [&](std::size_t i) {
      return analysis::Offset{feature.half_breadths[i], false};
    }));
    group.lines.push_back(line_of("z", count, unit, [&](std::size_t i) {
      return analysis::Offset{feature.heights[i], false};
    }));
  }
  std::erase_if(groups, [](const OffsetGroup& group) { return group.lines.empty(); });
  return groups;
}

// The measures of both forms. A form is a grid of cells beside a column of heads and below rows of
// heads; "along" is the direction in which the offsets of one station follow one another.
class Measures {
 public:
  Measures(const LinesDrawing& drawing, const std::vector<OffsetGroup>& groups, double letters)
      : size(letters), row(1.5 * letters) {
    const auto width = [this](const std::string& text, bool bold = false) {
      return text_size(text, size, bold).width + 2.0 * kCellPadding;
    };
    // Every cell has room for the mark, so that numbers end in one line with it or without.
    mark = text_size(kKnuckleMark, 0.75 * size, false).width;
    station_head = width("St.", true);
    for (const NamedCurves& station : drawing.stations) {
      station_head = std::max(station_head, width(station.label, true));
    }
    // The lying form has one width for all its columns, that of the widest number or station.
    cell = station_head + mark;
    for (const OffsetGroup& group : groups) {
      std::vector<double> widths;
      for (const OffsetLine& line : group.lines) {
        const double head = width(line.head, true);
        line_head = std::max(line_head, head);
        double widest = head + mark;
        for (const std::string& value : line.values) widest = std::max(widest, width(value) + mark);
        for (const std::string& value : line.values) cell = std::max(cell, width(value) + mark);
        widths.push_back(widest);
      }
      // Upright, the group's name needs its columns' width.
      const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
      const double missing = std::max(0.0, width(group.name, true) - sum);
      // Shared out evenly among them.
      for (double& w : widths) w += missing / static_cast<double>(widths.size());
      columns.push_back(std::move(widths));
      group_head = std::max(group_head, width(group.name, true));
      lines += group.lines.size();
    }
    // Title and legend stand in one row, and must not touch.
    title = width(title_of(drawing), true) + width(kLegend) + 2.0 * size;
  }

  double size, row;
  double mark = 0.0, station_head = 0.0, line_head = 0.0, group_head = 0.0, cell = 0.0, title = 0.0;
  std::vector<std::vector<double>> columns;  // upright: the widths of each group's columns
  std::size_t lines = 0;
};

class BlockDrawer {
 public:
  BlockDrawer(SheetBuilder& builder, const AlignedBox2d& box, const LinesDrawing& drawing,
              double letters)
      : builder_(builder),
        box_(box),
        drawing_(drawing),
        groups_(groups_of(drawing)),
        m_(drawing, groups_, letters) {}

  // A row for each station.
  void draw_upright() {
    draw_title();
    const double top = box_.min().y() + m_.row, left = box_.min().x(), right = box_.max().x();
    const double bottom = box_.max().y();
    // Below two rows of heads, of groups and of lines.
    const double first = top + 2.0 * m_.row;
    text("St.", true, {left + 0.5 * m_.station_head, first - 0.5 * m_.row}, Align::kCentre);
    for (std::size_t i = 0; i < drawing_.stations.size(); ++i) {
      text(drawing_.stations[i].label, true,
           {left + 0.5 * m_.station_head, first + (0.5 + static_cast<double>(i)) * m_.row},
           Align::kCentre);
      if (i > 0) horizontal(pens::kGrid, left, right, first + static_cast<double>(i) * m_.row);
    }
    double x = left + m_.station_head;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      vertical(pens::kTable, x, top, bottom);
      const double width = std::accumulate(m_.columns[g].begin(), m_.columns[g].end(), 0.0);
      text(groups_[g].name, true, {x + 0.5 * width, top + 0.5 * m_.row}, Align::kCentre);
      for (std::size_t k = 0; k < groups_[g].lines.size(); ++k) {
        const OffsetLine& line = groups_[g].lines[k];
        if (k > 0) vertical(pens::kGrid, x, top + m_.row, bottom);
        const double end = x + m_.columns[g][k] - kCellPadding - m_.mark;
        text(line.head, true, {end, first - 0.5 * m_.row}, Align::kRight);
        for (std::size_t i = 0; i < line.values.size(); ++i) {
          value(line, i, {end, first + (0.5 + static_cast<double>(i)) * m_.row});
        }
        x += m_.columns[g][k];
      }
    }
    horizontal(pens::kTable, left, right, first);
    builder_.draw(pens::kTable, outline_of({Vector2d(left, top), box_.max()}));
  }

  // A column for each station.
  void draw_lying() {
    draw_title();
    const double top = box_.min().y() + m_.row, left = box_.min().x(), right = box_.max().x();
    const double bottom = box_.max().y();
    // Beside two columns of heads; one row for the stations is above.
    const double heads = left + m_.group_head, first = heads + m_.line_head;
    text("Station", true, {left + kCellPadding, top + 0.5 * m_.row}, Align::kLeft);
    const auto cell_end = [&](std::size_t i) {
      return first + static_cast<double>(i + 1) * m_.cell - kCellPadding - m_.mark;
    };
    for (std::size_t i = 0; i < drawing_.stations.size(); ++i) {
      text(drawing_.stations[i].label, true, {cell_end(i), top + 0.5 * m_.row}, Align::kRight);
      // The first line parts heads from numbers.
      vertical(i == 0 ? pens::kTable : pens::kGrid, first + static_cast<double>(i) * m_.cell, top,
               bottom);
    }
    double y = top + m_.row;
    for (const OffsetGroup& group : groups_) {
      horizontal(pens::kTable, left, right, y);
      text(group.name, true, {left + kCellPadding, y + 0.5 * m_.row}, Align::kLeft);
      for (std::size_t k = 0; k < group.lines.size(); ++k) {
        const OffsetLine& line = group.lines[k];
        if (k > 0) horizontal(pens::kGrid, heads, right, y);
        const double middle = y + 0.5 * m_.row;
        text(line.head, true, {first - kCellPadding, middle}, Align::kRight);
        for (std::size_t i = 0; i < line.values.size(); ++i) {
          value(line, i, {cell_end(i), middle});
        }
        y += m_.row;
      }
    }
    builder_.draw(pens::kTable, outline_of({Vector2d(left, top), box_.max()}));
  }

 private:
  void draw_title() {
    const double y = box_.min().y() + 0.4 * m_.row;
    text(title_of(drawing_), true, {box_.min().x(), y}, Align::kLeft);
    text(kLegend, false, {box_.max().x(), y}, Align::kRight);
  }

  void text(const std::string& shown, bool bold, const Vector2d& at, Align align) {
    const TextStyle style{.size = m_.size, .bold = bold};
    builder_.put_text(shown, style, SheetBuilder::text_box(shown, style, at, align));
  }

  // The number ends at `end`; the mark of a knuckle follows.
  void value(const OffsetLine& line, std::size_t i, const Vector2d& end) {
    // Numbers of one column have their last digits in line.
    text(line.values[i], false, end, Align::kRight);
    if (!line.on_knuckle[i]) return;
    const TextStyle style{.size = 0.75 * m_.size};
    const Vector2d at(end.x() + 0.3, end.y());
    builder_.put_text(kKnuckleMark, style,
                      SheetBuilder::text_box(kKnuckleMark, style, at, Align::kLeft));
  }

  void vertical(const Pen& pen, double x, double top, double bottom) {
    builder_.draw(pen, {{x, top}, {x, bottom}});
  }
  void horizontal(const Pen& pen, double left, double right, double y) {
    builder_.draw(pen, {{left, y}, {right, y}});
  }

  SheetBuilder& builder_;
  const AlignedBox2d& box_;
  const LinesDrawing& drawing_;
  const std::vector<OffsetGroup> groups_;
  const Measures m_;
};

}  // namespace

std::vector<Vector2d> offsets_block_sizes(const LinesDrawing& drawing) {
  // Also where all stations were left out, as lying beyond the hull.
  if (!drawing.offsets || drawing.stations.empty()) return {};
  const std::vector<OffsetGroup> groups = groups_of(drawing);
  if (groups.empty()) return {};
  const double stations = static_cast<double>(drawing.stations.size());
  std::vector<Vector2d> sizes;
  for (const double letters : kLetterSizes) {
    const Measures m(drawing, groups, letters);
    double width = m.station_head;
    for (const std::vector<double>& columns : m.columns) {
      width = std::accumulate(columns.begin(), columns.end(), width);
    }
    // Title, two rows of heads, and the stations; lying, the title, the stations and the lines.
    // Forms come in pairs, upright and lying, as `form / 2` and `form % 2` below count on.
    sizes.emplace_back(std::max(width, m.title), (3.0 + stations) * m.row);
    sizes.emplace_back(std::max(m.group_head + m.line_head + stations * m.cell, m.title),
                       (2.0 + static_cast<double>(m.lines)) * m.row);
  }
  return sizes;
}

void draw_offsets_block(SheetBuilder& builder, const AlignedBox2d& box, const LinesDrawing& drawing,
                        int form) {
  BlockDrawer drawer(builder, box, drawing, kLetterSizes.at(form / 2));
  if (form % 2 == 0) {
    drawer.draw_upright();
  } else {
    drawer.draw_lying();
  }
}

}  // namespace hull::drawing

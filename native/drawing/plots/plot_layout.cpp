// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "drawing/paper/canvas.h"
#include "drawing/paper/text_meter.h"
#include "drawing/plots/plot_axes.h"
#include "drawing/plots/plot_legend.h"
#include "drawing/plots/plot_marks.h"
#include "drawing/plots/plot_pens.h"

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kTitleSize = 4.2, kTitleRow = 6.0;
constexpr double kSubtitleSize = 2.6, kSubtitleRow = 4.0;
constexpr double kHeadGap = 2.0;
constexpr double kLegendGap = 1.5;
constexpr double kPaperMargin = 12.0;
constexpr double kGreatestPlotSide = 5000.0;
constexpr double kLeastFrame = 1.0;        // mm, of its height
constexpr double kSharedSign = 4.5;        // mm, of curves that share an entry of the legend
constexpr double kRightOfFrame = 3.0;      // room for half of the last number
constexpr double kMostLegendShare = 0.5;   // of the height above the axes
constexpr double kMostRulersShare = 0.45;  // of the height
constexpr double kMostRulerColumn = 0.40;  // of the width

double head_height(const Plot& plot) {
  return (plot.title.empty() ? 0.0 : kTitleRow) +
         static_cast<double>(plot.subtitles.size()) * kSubtitleRow + kHeadGap;
}

void draw_head(SheetBuilder& builder, const Plot& plot, const AlignedBox2d& content) {
  Vector2d place = content.min();
  const auto put_row = [&](const std::string& text, TextStyle style, double row) {
    const FittedText fitted = fit_text(text, style.size, style.bold, content.sizes().x());
    style.size = fitted.size;
    const Vector2d middle = place + Vector2d(0.0, 0.5 * row);
    builder.put_text(fitted.text, style,
                     SheetBuilder::text_box(fitted.text, style, middle, Align::kLeft));
    place.y() += row;
  };
  if (!plot.title.empty()) put_row(plot.title, {.size = kTitleSize, .bold = true}, kTitleRow);
  for (const std::string& line : plot.subtitles) {
    put_row(line, {.size = kSubtitleSize, .ink = inks::kGrey}, kSubtitleRow);
  }
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// "500 t/div from 1000 t".
std::string division_text(const PlotAxis& axis, const AxisScale& scale) {
  const std::string after = axis.unit.empty() ? "" : " " + axis.unit;
  std::string text = number_text(scale.step) + after + "/div";
  if (scale.low != 0.0) text += " from " + number_text(scale.low) + after;
  return text;
}

// An entry for each axis, with the signs of its curves: "— S  — Aw: 200 m²/div".
std::vector<LegendEntry> division_entries(const Plot& plot, const PlotFrame& frame) {
  std::vector<LegendEntry> entries;
  for (int axis = 0; axis < static_cast<int>(plot.x_axes.size()); ++axis) {
    std::vector<LegendEntry> signs;
    for (int i = 0; i < static_cast<int>(plot.curves.size()); ++i) {
      const PlotCurve& curve = plot.curves[i];
      if (curve.x_axis != axis || curve.name.empty()) continue;
      signs.push_back({LegendSign::kLine, pen_of(plot, i),
                       curve.symbol.empty() ? curve.name : curve.symbol, kSharedSign});
    }
    if (signs.empty()) continue;
    LegendEntry entry = std::move(signs.back());
    signs.pop_back();
    // The short sign is for those that share an entry.
    if (signs.empty()) entry.width = LegendEntry{}.width;
    entry.text += ": " + division_text(plot.x_axes[axis], frame.x_axes[axis]);
    // The last curve carries the text that holds for all of them.
    entry.before = std::move(signs);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<LegendEntry> curve_entries(const Plot& plot) {
  std::vector<LegendEntry> entries;
  for (int i = 0; i < static_cast<int>(plot.curves.size()); ++i) {
    const PlotCurve& curve = plot.curves[i];
    if (!curve.name.empty()) entries.push_back({LegendSign::kLine, pen_of(plot, i), curve.name});
  }
  // A single curve is what title and axes say.
  if (entries.size() == 1) entries.clear();
  return entries;
}

std::vector<LegendEntry> legend_entries(const Plot& plot, const PlotFrame& frame, AxesKind kind,
                                        const Unlabelled& unlabelled) {
  std::vector<LegendEntry> entries;
  if (kind == AxesKind::kDivisions) entries = division_entries(plot, frame);
  if (kind == AxesKind::kSingle) entries = curve_entries(plot);
  for (std::size_t i = 0; i < plot.areas.size(); ++i) {
    if (plot.areas[i].label.empty()) continue;
    const Pen pen{0.0, area_colour(static_cast<int>(i))};
    entries.push_back({LegendSign::kSwatch, pen, plot.areas[i].label});
  }
  for (const int number : unlabelled.markers) {
    const PlotMarker& marker = plot.markers[number];
    const Ink ink = marker.curve < 0 ? inks::kBlack : colour_of(plot, marker.curve);
    entries.push_back({LegendSign::kDot, {0.0, ink}, marker.label, 2.0});
  }
  for (const int number : unlabelled.lines) {
    entries.push_back({LegendSign::kLine, pens::kReference, plot.lines[number].label});
  }
  for (const PlotBar& bar : plot.bars) {
    const AxisScale& scale = frame.x_axes[0];
    // As long as on the diagram, to measure by.
    const double width = bar.length / (scale.high - scale.low) * frame.area.sizes().x();
    entries.push_back(
        {LegendSign::kBar, pens::kBaseline, bar.label, std::min(width, frame.area.sizes().x())});
  }
  return entries;
}

struct Measures {
  PlotFrame frame;  // its lower end is where it would be without a legend
  AxesKind kind;
};

// Widths first: heights of the axes and of the legend follow from them.
Measures measure(const Plot& plot, const AlignedBox2d& content) {
  Measures measures;
  PlotFrame& frame = measures.frame;
  const double top = content.min().y() + head_height(plot);
  const double height = content.max().y() - top;
  measures.kind = AxesKind::kSingle;
  if (plot.x_axes.size() > 1) {
    const bool fits = axes_height(AxesKind::kRulers, plot) <= kMostRulersShare * height;
    measures.kind = fits ? AxesKind::kRulers : AxesKind::kDivisions;
  }
  // The legend's height is not known yet: it is taken for one row. Only how many steps there are
  // depends on it.
  frame.y_axis = y_scale(plot, height - axes_height(measures.kind, plot) - kLegendRow);
  const double left = content.min().x() + kAxisNameRow + number_width(frame.y_axis) + 2.6;
  double right = content.max().x() - kRightOfFrame;
  frame.x_axes = x_scales(plot, right - left);
  if (measures.kind == AxesKind::kRulers) {
    // The column beside the rulers has the units that follow from the scales; these are then made
    // anew for the width that is left.
    const double column = ruler_column(plot, frame.x_axes);
    right = content.max().x() - std::min(column, kMostRulerColumn * content.sizes().x());
    frame.x_axes = x_scales(plot, right - left);
  }
  const double bottom = content.max().y() - axes_height(measures.kind, plot);
  frame.area = AlignedBox2d(Vector2d(left, top), Vector2d(right, bottom));
  return measures;
}

std::vector<PlottedCurve> draw_curves(SheetBuilder& builder, const Plot& plot,
                                      const PlotFrame& frame) {
  std::vector<PlottedCurve> drawn;
  for (int i = 0; i < static_cast<int>(plot.curves.size()); ++i) {
    PlottedCurve& plotted = drawn.emplace_back(PlottedCurve{i, {}, {}});
    plotted.paths = curve_paths(plot.curves[i], frame);
    const Pen pen = pen_of(plot, i);
    for (const PagePath& path : plotted.paths) {
      if (path.size() == 1) {
        builder.fill(pen.colour, dot_outline(path.front()));
        // As an obstacle a dot is a little larger than it is drawn.
        builder.occupy({path.front(), Vector2d::Constant(1.0)});
        plotted.numbers.push_back(LabelPlacer::kNoCurve);
      } else {
        plotted.numbers.push_back(builder.draw_curve(pen, path));
      }
    }
  }
  return drawn;
}

void draw_areas(SheetBuilder& builder, const Plot& plot, const PlotFrame& frame) {
  for (std::size_t i = 0; i < plot.areas.size(); ++i) {
    const PlotArea& area = plot.areas[i];
    for (PagePath& polygon : area_polygons(plot.curves[area.curve], area.from, area.to, frame)) {
      builder.shade(area_colour(static_cast<int>(i)), std::move(polygon));
    }
  }
}

struct Attempt {
  PlotSheet sheet;
  Unlabelled unlabelled;
};

// Titles and axes take what they need, however low the page is.
void check_frame(const Plot& plot, const PlotPage& page, const AlignedBox2d& area) {
  if (area.max().y() - area.min().y() >= kLeastFrame) return;
  throw std::invalid_argument("A plot cannot be laid out on a page " + number_text(page.height) +
                              " mm high: its title, " + std::to_string(plot.subtitles.size()) +
                              " subtitles, axes and legend leave no room for the diagram; take "
                              "fewer, or a higher page");
}

// One layout, with the legend explaining what is in `unlabelled`.
Attempt attempt(const Plot& plot, const PlotPage& page, const Unlabelled& unlabelled) {
  const AlignedBox2d content(Vector2d::Constant(page.margin),
                             Vector2d(page.width - page.margin, page.height - page.margin));
  auto [frame, kind] = measure(plot, content);
  const double height = frame.area.sizes().y();
  const int most_rows = std::max(1, static_cast<int>(kMostLegendShare * height / kLegendRow));
  const PlotLegend legend(legend_entries(plot, frame, kind, unlabelled), content.sizes().x(),
                          most_rows);
  const double legend_height = legend.height() > 0.0 ? legend.height() + kLegendGap : 0.0;
  frame.area.max().y() -= legend_height;
  check_frame(plot, page, frame.area);

  PlotSheet sheet{};
  sheet.title = plot.title;
  sheet.width = page.width;
  sheet.height = page.height;
  SheetBuilder builder(sheet);
  draw_head(builder, plot, content);
  draw_areas(builder, plot, frame);
  draw_grid(builder, frame);
  draw_y_axis(builder, plot, frame, content.min().x());
  draw_x_axes(builder, plot, frame, kind, content.max().x());
  legend.draw(builder, {content.min().x(), content.max().y() - legend.height()});
  // Curves first, then marks, then symbols: each avoids what is there, and curves can't give way.
  const std::vector<PlottedCurve> curves = draw_curves(builder, plot, frame);
  const Unlabelled left = draw_marks(builder, plot, frame, unlabelled);
  draw_symbols(builder, plot, frame, curves);
  static_cast<Sheet&>(sheet) = std::move(builder).finish();
  sheet.frame = frame;
  return {std::move(sheet), left};
}

void check_page(const PlotPage& page) {
  for (const double side : {page.width, page.height}) {
    // Written so that what is no number fails too.
    const double room = side - 2.0 * page.margin;
    if (!(page.margin >= 0.0) || !(room >= kLeastPlotSide) || !(side <= kGreatestPlotSide)) {
      throw std::invalid_argument("A plot cannot be laid out on " + number_text(page.width) +
                                  " mm by " + number_text(page.height) + " mm with a margin of " +
                                  number_text(page.margin) + " mm: " + number_text(kLeastPlotSide) +
                                  " mm must remain, and no side be "
                                  "above " +
                                  number_text(kGreatestPlotSide) + " mm");
    }
  }
}

}  // namespace

PlotSheet lay_out_plot(const Plot& plot, const PlotPage& page) {
  check_plot(plot);
  check_page(page);
  Attempt made = attempt(plot, page, {});
  // What finds no room goes to the legend, which takes room from the diagram. Each time round at
  // least one more is in the legend, so this ends.
  for (Unlabelled explained; made.unlabelled != explained;) {
    explained = made.unlabelled;
    made = attempt(plot, page, explained);
  }
  return std::move(made.sheet);
}

void write_plot(const Plot& plot, const std::string& path, Paper paper) {
  check_drawing_path(path);
  const PaperSize size = paper_size(paper);
  write_sheet(lay_out_plot(plot, {size.width, size.height, kPaperMargin}), path);
}

}  // namespace hull::drawing

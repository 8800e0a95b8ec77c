// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "drawing/paper/pens.h"
#include "drawing/paper/text_meter.h"
#include "drawing/plots/plot_layout.h"
#include "drawing/plots/plot_scale.h"

namespace hull::drawing {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const PlotPage kPaper{297.0, 210.0, 12.0};
const PlotPage kCard{110.0, 75.0, 3.0};

Plot empty_plot() {
  Plot plot;
  plot.title = "Plot";
  plot.x_axes = {{"Heel φ", "°", {}, false}};
  plot.y_axis = {"Lever", "m", {}, true};
  return plot;
}

PlotCurve sampled(const std::string& name, double low, double high, double (*y)(double)) {
  PlotCurve curve;
  curve.name = name;
  for (int i = 0; i <= 60; ++i) {
    curve.x.push_back(low + (high - low) * i / 60.0);
    curve.y.push_back(y(curve.x.back()));
  }
  return curve;
}

Plot righting_levers() {
  Plot plot = empty_plot();
  plot.subtitles = {"Coaster, KG 4.35 m"};
  plot.curves = {sampled("GZ", 0.0, 90.0, [](double x) { return std::sin(x * 0.04); })};
  plot.markers = {{39.3, 1.0, "max 1.000 m at 39.3°", 0}, {78.5, 0.0, "φv 78.5°", 0}};
  plot.lines = {{22.1, true, "deck edge 22.1°"}, {48.0, true, "flooding 48.0°"}};
  plot.areas = {{0, 0.0, 30.0, "area 0° to 30°"}, {0, 30.0, 40.0, "area 30° to 40°"}};
  return plot;
}

Plot hydrostatic_curves(int count) {
  Plot plot;
  plot.title = "Hydrostatic curves";
  plot.y_axis = {"Draft", "m", {}, false};
  for (int i = 0; i < count; ++i) {
    plot.x_axes.push_back({"", "m³", {}, false});
    PlotCurve curve{"Quantity " + std::to_string(i),
                    "Q" + std::to_string(i),
                    {},
                    {},
                    i,
                    {},
                    LineStyle::kSolid,
                    false};
    for (int k = 0; k <= 20; ++k) {
      curve.y.push_back(1.0 + 0.2 * k);
      curve.x.push_back(std::pow(10.0, i) * (1.0 + std::pow(0.05 * k, 0.5 + 0.2 * i)));
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

// What holds of every plot, whatever is drawn.
void expect_good_layout(const PlotSheet& sheet, const PlotPage& page) {
  Eigen::AlignedBox2d content(
      Eigen::Vector2d::Constant(page.margin - 1e-9),
      Eigen::Vector2d(page.width - page.margin + 1e-9, page.height - page.margin + 1e-9));
  EXPECT_GT(sheet.frame.area.sizes().minCoeff(), 8.0);
  for (const Stroke& stroke : sheet.strokes) {
    ASSERT_GE(stroke.points.size(), 2u);
    for (const Eigen::Vector2d& p : stroke.points) ASSERT_TRUE(content.contains(p));
  }
  for (const auto* fills : {&sheet.areas, &sheet.patches}) {
    for (const Fill& fill : *fills) {
      ASSERT_GE(fill.points.size(), 3u);
      for (const Eigen::Vector2d& p : fill.points) ASSERT_TRUE(content.contains(p));
    }
  }
  for (std::size_t i = 0; i < sheet.labels.size(); ++i) {
    for (const Eigen::Vector2d& corner : sheet.labels[i].box.corners()) {
      EXPECT_TRUE(content.contains(corner)) << sheet.labels[i].text;
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(overlap(sheet.labels[i].box, sheet.labels[j].box))
          << sheet.labels[i].text << " over " << sheet.labels[j].text;
    }
  }
}

bool has_label(const Sheet& sheet, const std::string& text) {
  for (const Label& label : sheet.labels) {
    if (label.text == text) return true;
  }
  return false;
}

TEST(PlotScale, RoundStepsThatCoverTheRange) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> power(-9.0, 9.0), sign(-1.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    const double a = sign(random) * std::pow(10.0, power(random));
    const double b = sign(random) * std::pow(10.0, power(random));
    const PlotRange range = widened({std::min(a, b), std::max(a, b)}, trial % 2 == 0);
    for (int most : {2, 5, 12}) {
      for (const AxisScale& scale : {rounded_scale(range, most), divided_scale(range, most)}) {
        EXPECT_LE(scale.low, range.low + 1e-6 * scale.step) << a << " " << b;
        EXPECT_GE(scale.high, range.high - 1e-6 * scale.step);
        const double mantissa =
            scale.step / std::pow(10.0, std::floor(std::log10(scale.step) + 1e-9));
        double nearest = 1.0;
        for (double usual : {1.0, 2.0, 2.5, 5.0}) {
          nearest = std::min(nearest, std::abs(mantissa - usual));
        }
        EXPECT_LT(nearest, 1e-9);
        EXPECT_LE(scale.ticks().size(), static_cast<std::size_t>(most) + 2u);
      }
      EXPECT_EQ(divided_scale(range, most).ticks().size(), static_cast<std::size_t>(most) + 1u);
    }
  }
}

TEST(PlotScale, NumbersAsTheyAreWritten) {
  const AxisScale tenths = rounded_scale({-0.3, 0.8}, 12);
  EXPECT_EQ(tenths.text(tenths.ticks().front()), "−0.3");
  EXPECT_EQ(tenths.text(0.1 * 3 - 0.3), "0.0");
  const AxisScale quarters = divided_scale({0.0, 24.0}, 10);
  EXPECT_EQ(quarters.text(2.5), "2.5");
  const AxisScale large = rounded_scale({0.0, 3e9}, 6);
  EXPECT_EQ(large.unit_text("t"), "10⁹ t");
  EXPECT_EQ(large.text(1e9), "1.0");
  const AxisScale small = rounded_scale({0.0, 4e-9}, 4);
  EXPECT_EQ(small.unit_text(""), "10⁻⁹");
  EXPECT_EQ(small.text(2e-9), "2");
}

TEST(Plot, LayoutOfRightingLevers) {
  for (const PlotPage& page : {kPaper, kCard}) {
    const PlotSheet sheet = lay_out_plot(righting_levers(), page);
    expect_good_layout(sheet, page);
    // Beside its dot or in the legend, every text is somewhere.
    for (const char* text :
         {"max 1.000 m at 39.3°", "φv 78.5°", "deck edge 22.1°", "flooding 48.0°", "area 0° to 30°",
          "area 30° to 40°", "Heel φ [°]", "Lever [m]"}) {
      EXPECT_TRUE(has_label(sheet, text)) << text;
    }
    EXPECT_EQ(sheet.areas.size(), 2u);
  }
}

TEST(Plot, ShadedAreaIsThatUnderTheCurve) {
  Plot plot = empty_plot();
  plot.curves = {sampled("parabola", 0.0, 60.0, [](double x) { return x * (60.0 - x); })};
  plot.areas = {{0, 15.0, 45.0, "area"}};
  const PlotSheet sheet = lay_out_plot(plot, kPaper);
  ASSERT_EQ(sheet.areas.size(), 1u);
  double twice = 0.0;
  const auto& points = sheet.areas[0].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  const Eigen::Vector2d unit = sheet.frame.to_page(0, 1.0, 1.0) - sheet.frame.to_page(0, 0.0, 0.0);
  // The integral of x (60 - x) from 15 to 45, less the 30 chords' part: 1/6 each.
  EXPECT_NEAR(0.5 * std::abs(twice), (24750.0 - 5.0) * std::abs(unit.x() * unit.y()), 1e-6 * twice);
}

TEST(Plot, AreasMayBeGivenFromTheirEnd) {
  Plot plot = empty_plot();
  plot.curves = {sampled("parabola", 0.0, 60.0, [](double x) { return x * (60.0 - x); })};
  plot.areas = {{0, 15.0, 45.0, "area"}, {0, 45.0, 15.0, "area"}};
  const PlotSheet sheet = lay_out_plot(plot, kPaper);
  ASSERT_EQ(sheet.areas.size(), 2u);
  EXPECT_EQ(sheet.areas[0].points, sheet.areas[1].points);
}

// Texts around dots that leave little room are led to along diagonals, too.
TEST(Plot, LeadersRunInAllDirections) {
  Plot plot = empty_plot();
  plot.x_axes[0].range = PlotRange{0.0, 100.0};
  plot.y_axis.range = PlotRange{0.0, 100.0};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) plot.markers.push_back({48.0 + i, 48.0 + 1.5 * j, "mark"});
  }
  const PlotSheet sheet = lay_out_plot(plot, kPaper);
  expect_good_layout(sheet, kPaper);
  int diagonal = 0;
  for (const Stroke& stroke : sheet.strokes) {
    if (!(stroke.pen == pens::kLeader)) continue;
    const Eigen::Vector2d way = (stroke.points[1] - stroke.points[0]).cwiseAbs();
    diagonal += way.minCoeff() > 0.5;
    // Outside the dots.
    for (const PlotMarker& marker : plot.markers) {
      const Eigen::Vector2d dot = sheet.frame.to_page(0, marker.x, marker.y);
      EXPECT_GT((stroke.points[0] - dot).norm(), 0.8);
    }
  }
  EXPECT_GT(diagonal, 0);
}

TEST(Plot, LinesOutOfSightAreInTheLegendByTheirNames) {
  // Without a legend.
  Plot plot = empty_plot();
  plot.x_axes[0].range = PlotRange{0.0, 90.0};
  plot.curves = {sampled("GZ", 0.0, 90.0, [](double x) { return std::sin(x * 0.04); })};
  const double bottom = lay_out_plot(plot, kPaper).frame.area.max().y();
  plot.lines = {{1000.0, true, ""}};
  EXPECT_EQ(lay_out_plot(plot, kPaper).frame.area.max().y(), bottom);
  plot.lines.back().label = "far away";
  EXPECT_TRUE(has_label(lay_out_plot(plot, kPaper), "far away"));
}

TEST(Plot, LayoutOfManyScales) {
  for (int count : {1, 2, 5, 9}) {
    for (const PlotPage& page : {kPaper, kCard, PlotPage{420.0, 297.0, 12.0}}) {
      const PlotSheet sheet = lay_out_plot(hydrostatic_curves(count), page);
      expect_good_layout(sheet, page);
      const std::size_t ticks = sheet.frame.x_axes[0].ticks().size();
      for (const AxisScale& scale : sheet.frame.x_axes) {
        // One grid is everyone's.
        if (count > 1) {
          EXPECT_EQ(scale.ticks().size(), ticks);
        }
      }
      for (const PlotCurve& curve : hydrostatic_curves(count).curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
          const auto place = sheet.frame.to_page(curve.x_axis, curve.x[i], curve.y[i]);
          EXPECT_LT(sheet.frame.area.exteriorDistance(place), 1e-6);
        }
      }
    }
  }
}

TEST(Plot, OddDataComeOutWell) {
  const std::vector<std::pair<std::vector<double>, std::vector<double>>> data{
      {{}, {}},
      {{1.0}, {2.0}},
      {{kNan}, {1.0}},
      {{1.0, 2.0, 3.0}, {5.0, 5.0, 5.0}},
      {{1.0, 1.0}, {0.0, 1.0}},
      {{0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, kNan, 1.0, std::numeric_limits<double>::infinity(), 2.0}},
      {{1e-9, 2e-9}, {1e9, 3e9}},
      {{1e9, 1e9 + 1e-6}, {-1e-9, 1e-9}},
      {{-1e90, 1e90}, {1e-90, 2e-90}},
  };
  for (const auto& [x, y] : data) {
    Plot plot = empty_plot();
    PlotCurve curve;
    curve.name = std::string(400, 'n') + " ∇ φ m³";
    curve.symbol = "∇";
    curve.x = x;
    curve.y = y;
    plot.curves = {curve, curve};
    plot.title = std::string(400, 'T');
    for (const PlotPage& page : {kPaper, kCard}) expect_good_layout(lay_out_plot(plot, page), page);
  }
}

TEST(Plot, InterruptedCurvesAndSinglePoints) {
  Plot plot = empty_plot();
  PlotCurve curve;
  curve.x = {0, 1, 2, 3, 4, 5, 6};
  curve.y = {0, 1, kNan, 2, kNan, 1, 0};
  plot.curves = {curve};
  const PlotSheet sheet = lay_out_plot(plot, kPaper);
  EXPECT_EQ(curve_paths(curve, sheet.frame).size(), 3u);
  EXPECT_EQ(sheet.patches.size(), 1u);  // the dot of the lonely point
}

TEST(Plot, FixedRangesClipTheCurves) {
  Plot plot = empty_plot();
  plot.curves = {sampled("parabola", -10.0, 10.0, [](double x) { return x * x; })};
  plot.y_axis.range = PlotRange{0.0, 50.0};
  const PlotSheet sheet = lay_out_plot(plot, kPaper);
  expect_good_layout(sheet, kPaper);
  const std::vector<PagePath> paths = curve_paths(plot.curves[0], sheet.frame);
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(paths[0].front().y(), sheet.frame.area.min().y(), 1e-6);
  EXPECT_NEAR(paths[0].front().x(), sheet.frame.page_x(0, -std::sqrt(50.0)), 0.02);
}

TEST(Plot, ManyNamesEndInACount) {
  Plot plot = empty_plot();
  for (int i = 0; i < 200; ++i) {
    plot.curves.push_back(
        sampled("curve of some name " + std::to_string(i), 0.0, 1.0, [](double x) { return x; }));
  }
  for (const PlotPage& page : {kPaper, kCard}) {
    const PlotSheet sheet = lay_out_plot(plot, page);
    expect_good_layout(sheet, page);
    bool counted = false;
    for (const Label& label : sheet.labels) counted |= label.text.find("more") != std::string::npos;
    EXPECT_TRUE(counted);
  }
}

// Six names in four rows: two columns hold them when they are a little smaller.
TEST(Plot, NamesAreMadeSmallerRatherThanLeftOut) {
  const PlotPage card{93.75, 66.0, 3.0};
  Plot plot = empty_plot();
  for (int i = 0; i < 6; ++i) {
    plot.curves.push_back(sampled("area 30° to 4" + std::to_string(i) + "°: 0.094 m·rad", 0.0, 1.0,
                                  [](double x) { return x; }));
  }
  const PlotSheet sheet = lay_out_plot(plot, card);
  expect_good_layout(sheet, card);
  int names = 0;
  for (const Label& label : sheet.labels) {
    EXPECT_EQ(label.text.find("more"), std::string::npos);
    EXPECT_EQ(label.text.find("…"), std::string::npos) << label.text;
    if (label.text.find("area 30°") == std::string::npos) continue;
    ++names;
    EXPECT_GE(label.size, 0.8 * 2.5 - 1e-9);
  }
  EXPECT_GE(names, 6);
}

TEST(Plot, RefusesWhatCannotBeDrawn) {
  const auto refused = [](const auto& spoil) {
    Plot plot = righting_levers();
    spoil(plot);
    EXPECT_THROW(lay_out_plot(plot, kPaper), std::invalid_argument);
  };
  refused([](Plot& plot) { plot.x_axes.clear(); });
  refused([](Plot& plot) { plot.curves[0].x.pop_back(); });
  refused([](Plot& plot) { plot.curves[0].x_axis = 1; });
  refused([](Plot& plot) { plot.curves[0].y[3] = 1e200; });
  refused([](Plot& plot) { plot.markers[0].x = kNan; });
  refused([](Plot& plot) { plot.markers[0].curve = 7; });
  refused([](Plot& plot) { plot.lines[0].at = kNan; });
  refused([](Plot& plot) { plot.areas[0].curve = -1; });
  refused([](Plot& plot) { plot.bars = {{0.0, "bar"}}; });
  refused([](Plot& plot) { plot.y_axis.range = PlotRange{1.0, 1.0}; });
  // Steps of these would be so many from zero that one more is the same number.
  refused([](Plot& plot) { plot.y_axis.range = PlotRange{1.0, 1.0 + 1e-15}; });
  refused([](Plot& plot) { plot.x_axes[0].range = PlotRange{-1e9, -1e9 + 0.5}; });
  refused([](Plot& plot) { plot.y_axis.range = PlotRange{0.0, 1e-300}; });
  // Heads that leave no room for a frame.
  refused([](Plot& plot) { plot.subtitles.resize(60, "subtitle"); });
  EXPECT_THROW(lay_out_plot(righting_levers(), {40.0, 75.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(lay_out_plot(righting_levers(), {kNan, 75.0, 3.0}), std::invalid_argument);
  EXPECT_THROW(write_plot(righting_levers(), "plot.dwg"), std::invalid_argument);
}

}  // namespace
}  // namespace hull::drawing

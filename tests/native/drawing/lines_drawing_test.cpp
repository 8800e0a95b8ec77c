// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/lines_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "drawing/hand_made_hulls.h"
#include "drawing/paper/pens.h"

namespace hull::drawing {
namespace {

using test::barge_lines;
using test::Wigley;

// What holds of every sheet, whatever is drawn.
void expect_good_layout(const LinesSheet& sheet) {
  const Eigen::AlignedBox2d page(Eigen::Vector2d(0, 0), Eigen::Vector2d(sheet.width, sheet.height));
  EXPECT_TRUE(page.contains(sheet.frame));
  for (const Stroke& stroke : sheet.strokes) {
    ASSERT_GE(stroke.points.size(), 2u);
    for (const Eigen::Vector2d& p : stroke.points) {
      // Frame lines lie on the frame's border, rounded.
      ASSERT_LT(sheet.frame.exteriorDistance(p), 1e-9);
    }
  }
  for (std::size_t i = 0; i < sheet.labels.size(); ++i) {
    for (const Eigen::Vector2d& corner : sheet.labels[i].box.corners()) {
      EXPECT_TRUE(sheet.frame.contains(corner)) << sheet.labels[i].text;
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(overlap(sheet.labels[i].box, sheet.labels[j].box))
          << sheet.labels[i].text << " over " << sheet.labels[j].text;
    }
  }
  for (const View* a : {&sheet.profile, &sheet.half_breadth, &sheet.body_plan}) {
    EXPECT_TRUE(sheet.frame.contains(a->bounds));
    EXPECT_FALSE(a->bounds.intersects(sheet.title_block));
    EXPECT_NEAR(a->scale, 1000.0 / sheet.scale_denominator, 1e-12);
  }
  if (!sheet.table.isEmpty()) {
    EXPECT_TRUE(sheet.frame.contains(sheet.table));
    EXPECT_FALSE(sheet.table.intersects(sheet.title_block));
    for (const View* view : {&sheet.profile, &sheet.half_breadth, &sheet.body_plan}) {
      EXPECT_FALSE(view->bounds.intersects(sheet.table));
    }
  }
  EXPECT_FALSE(sheet.profile.bounds.intersects(sheet.body_plan.bounds));
  EXPECT_FALSE(sheet.half_breadth.bounds.intersects(sheet.body_plan.bounds));
  // Beside the profile, the body plan stands on the same base line.
  if (sheet.body_plan.bounds.min().y() < sheet.profile.bounds.max().y()) {
    EXPECT_NEAR(sheet.body_plan.origin.y(), sheet.profile.origin.y(), 1e-9);
  }
  // The bow to the right, and every x of the half-breadth plan below the same x of the profile.
  EXPECT_EQ(sheet.profile.origin.x(), sheet.half_breadth.origin.x());
  EXPECT_LT(sheet.profile.bounds.max().y(), sheet.half_breadth.bounds.min().y() + 1e-9);
}

TEST(LinesDrawing, LayoutOfAWigleyHull) {
  for (Paper paper : {Paper::kA4, Paper::kA3, Paper::kA1}) {
    LinesDrawing drawing = Wigley{}.lines();
    drawing.paper = paper_size(paper);
    expect_good_layout(lay_out_lines(drawing));
  }
}

TEST(LinesDrawing, LayoutOfABarge) { expect_good_layout(lay_out_lines(barge_lines())); }

TEST(LinesDrawing, LayoutOfSmallAndLargeHulls) {
  for (double length : {4.0, 30.0, 400.0}) {
    Wigley hull;
    const double factor = length / hull.length;
    hull = {length, factor * hull.beam, factor * hull.draft, factor * hull.depth};
    const LinesSheet sheet = lay_out_lines(hull.lines());
    expect_good_layout(sheet);
    EXPECT_LT(length * 1000.0 / sheet.scale_denominator, sheet.width);
  }
}

// The largest scale that fits is a usual one, and more paper gives a larger one.
TEST(LinesDrawing, ScaleIsUsualAndGrowsWithThePaper) {
  double previous = std::numeric_limits<double>::infinity();
  for (Paper paper : {Paper::kA4, Paper::kA3, Paper::kA2, Paper::kA1, Paper::kA0}) {
    LinesDrawing drawing = Wigley{}.lines();
    drawing.paper = paper_size(paper);
    const double scale = lay_out_lines(drawing).scale_denominator;
    EXPECT_LE(scale, previous);
    const double mantissa = scale / std::pow(10.0, std::floor(std::log10(scale)));
    const std::vector<double> usual = {1.0, 1.25, 2.0, 2.5, 3.0, 5.0, 7.5};
    EXPECT_NE(std::find(usual.begin(), usual.end(), mantissa), usual.end()) << scale;
    previous = scale;
  }
}

TEST(LinesDrawing, EveryLineIsDrawn) {
  const LinesDrawing drawing = Wigley{}.lines();
  const LinesSheet sheet = lay_out_lines(drawing);
  const auto count = [&sheet](const Pen& pen) {
    return std::count_if(sheet.strokes.begin(), sheet.strokes.end(),
                         [&pen](const Stroke& stroke) { return stroke.pen == pen; });
  };
  // Sections with an extent: those at the perpendiculars of this hull lie in the centre line.
  EXPECT_GE(count(pens::kStation), 19);
  EXPECT_GE(count(pens::kWaterline), 7);
  EXPECT_EQ(count(pens::kLoadWaterline), 1);
  EXPECT_EQ(count(pens::kButtock), 4);
  EXPECT_GE(count(pens::kOutline), 2);
}

TEST(LinesDrawing, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(lay_out_lines(LinesDrawing{}), std::invalid_argument);
  LinesDrawing drawing = Wigley{}.lines();
  drawing.stations[3].curves[0].points[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(lay_out_lines(drawing), std::invalid_argument);
  drawing = Wigley{}.lines();
  drawing.waterlines[0].curves[0].points.resize(1);
  EXPECT_THROW(lay_out_lines(drawing), std::invalid_argument);
  drawing = Wigley{}.lines();
  drawing.particulars.resize(kMostParticulars + 1, {"Name", "value"});
  EXPECT_THROW(lay_out_lines(drawing), std::invalid_argument);
}

// With all that a plan can have: diagonals, frames, title rows, and offsets.
LinesDrawing full_drawing(const Wigley& hull) {
  LinesDrawing drawing = hull.lines();
  for (const double angle : {0.4, 0.8}) drawing.diagonals.push_back(hull.diagonal(6.0, angle));
  drawing.frame_spacing = 0.7;
  drawing.title_rows = {{"Drawn", "N. N."}, {"Date", "1 May"}, {"Drawing no.", "7"}};
  drawing.offsets = hull.offsets(drawing);
  return drawing;
}

TEST(LinesDrawing, LayoutWithEverything) {
  for (Paper paper : {Paper::kA4, Paper::kA3, Paper::kA2, Paper::kA1, Paper::kA0}) {
    LinesDrawing drawing = full_drawing(Wigley{});
    drawing.paper = paper_size(paper);
    if (paper == Paper::kA4) drawing.offsets.reset();
    const LinesSheet sheet = lay_out_lines(drawing);
    expect_good_layout(sheet);
    EXPECT_EQ(sheet.table.isEmpty(), paper == Paper::kA4);
  }
}

TEST(LinesDrawing, LayoutOnSheetsOfAnyShape) {
  for (const auto& [width, height] : {std::pair(900.0, 300.0), {400.0, 800.0}, {2000.0, 1000.0}}) {
    LinesDrawing drawing = full_drawing(Wigley{});
    drawing.paper = own_paper_size(width, height);
    const LinesSheet sheet = lay_out_lines(drawing);
    expect_good_layout(sheet);
    EXPECT_EQ(sheet.width, width);
  }
  EXPECT_THROW(own_paper_size(50.0, 500.0), std::invalid_argument);
}

TEST(LinesDrawing, KeepsToAScaleOrTellsOneThatFits) {
  LinesDrawing drawing = full_drawing(Wigley{});
  drawing.scale_denominator = 800.0;
  const LinesSheet sheet = lay_out_lines(drawing);
  EXPECT_EQ(sheet.scale_denominator, 800.0);
  expect_good_layout(sheet);
  drawing.scale_denominator = 50.0;
  try {
    lay_out_lines(drawing);
    FAIL() << "100 m at 1:50 on A3";
  } catch (const std::invalid_argument& refused) {
    drawing.scale_denominator.reset();
    const double fits = lay_out_lines(drawing).scale_denominator;
    const std::string wanted = "1:" + std::to_string(std::lround(fits)) + " does";
    EXPECT_NE(std::string(refused.what()).find(wanted), std::string::npos) << refused.what();
  }
  drawing.scale_denominator = 0.0;
  EXPECT_THROW(lay_out_lines(drawing), std::invalid_argument);
}

TEST(LinesDrawing, RefusesLinesThatRunTogether) {
  LinesDrawing drawing = Wigley{}.lines();
  for (int i = 0; i < 900; ++i) drawing.stations.push_back(Wigley{}.station(0.1 * i, "x"));
  EXPECT_THROW(lay_out_lines(drawing), std::invalid_argument);
}

// The table's numbers are there, in millimetres and each mark beside its own.
TEST(LinesDrawing, OffsetsAreOnTheSheet) {
  LinesDrawing drawing = full_drawing(Wigley{});
  drawing.offsets->half_breadths[40] = {4.321, true};
  const LinesSheet sheet = lay_out_lines(drawing);
  const auto find = [&sheet](const std::string& text) {
    return std::find_if(sheet.labels.begin(), sheet.labels.end(),
                        [&](const Label& label) { return label.text == text; });
  };
  const auto number = find("4321"), mark = find("K");
  ASSERT_NE(number, sheet.labels.end());
  ASSERT_NE(mark, sheet.labels.end());
  EXPECT_TRUE(sheet.table.contains(number->box.centre));
  const Eigen::Vector2d step = mark->box.centre - number->box.centre;
  EXPECT_LT(std::abs(step.y()), 1.0);
  EXPECT_NEAR(step.x(), number->box.half.x() + mark->box.half.x(), 0.5);
}

// The scale of frames: frame k is at x = k times their distance.
TEST(LinesDrawing, FramesAreInTheirPlaces) {
  const LinesSheet sheet = lay_out_lines(full_drawing(Wigley{}));
  int marks = 0;
  for (const Stroke& stroke : sheet.strokes) {
    if (!(stroke.pen == pens::kFrameScale) || stroke.points[0].x() != stroke.points[1].x()) {
      continue;
    }
    const double x = (stroke.points[0].x() - sheet.profile.origin.x()) / sheet.profile.scale;
    EXPECT_NEAR(x / 0.7, std::round(x / 0.7), 1e-9);
    ++marks;
  }
  EXPECT_EQ(marks, 143);  // 0 to 142 within 100 m
}

// Below the centre line a diagonal's curve is at its distance along the plane; in the body plan its
// trace has the plane's slope.
TEST(LinesDrawing, DiagonalsAreExpandedAndStraight) {
  const LinesDrawing drawing = full_drawing(Wigley{});
  const LinesSheet sheet = lay_out_lines(drawing);
  double deepest = 0.0;
  int traces = 0;
  for (const Stroke& stroke : sheet.strokes) {
    if (stroke.pen == pens::kDiagonal) {
      for (const auto& p : stroke.points) {
        deepest = std::max(deepest, (p.y() - sheet.half_breadth.origin.y()));
      }
    }
    if (stroke.pen == pens::kDiagonalTrace) {
      const Eigen::Vector2d way = stroke.points[1] - stroke.points[0];
      const double angle = std::atan2(way.y(), std::abs(way.x()));
      EXPECT_LT(std::min(std::abs(angle - 0.4), std::abs(angle - 0.8)), 1e-9);
      ++traces;
    }
  }
  double wanted = 0.0;
  for (const NamedDiagonal& member : drawing.diagonals) {
    for (const auto& p : member.curves[0].points) {
      wanted = std::max(wanted, std::hypot(p.y(), member.diagonal.height - p.z()));
    }
  }
  EXPECT_EQ(traces, 4);
  EXPECT_NEAR(deepest / sheet.profile.scale, wanted, 1e-9);
}

}  // namespace
}  // namespace hull::drawing

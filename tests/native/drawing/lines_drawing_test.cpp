// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "drawing/hand_made_hulls.h"
#include "drawing/pens.h"

namespace hull {
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
    EXPECT_TRUE(mantissa == 1.0 || mantissa == 2.0 || mantissa == 2.5 || mantissa == 5.0) << scale;
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

}  // namespace
}  // namespace hull

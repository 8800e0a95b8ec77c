// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a lines plan and the places of its views on the paper.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "drawing/lines_plan/hull_extents.h"
#include "drawing/lines_plan/lines_sheet.h"
#include "drawing/paper/paper.h"

namespace hull::drawing {

// Room kept around the hull itself in its views, in millimetres.
inline constexpr double kOverhang = 4.0;  // grid lines beyond the hull
inline constexpr double kSideOverhang =
    9.0;                                  // the same at the sides of the body plan: station labels
inline constexpr double kFanRow = 9.0;    // above the body plan: more station labels
inline constexpr double kLabelRow = 5.0;  // a row of labels above or below the grid
inline constexpr double kFrameRow = 6.5;  // the scale of frames, below the labels of the profile
inline constexpr double kCaptionRow = 7.0;  // the name of the view
inline constexpr double kColumnGap = 1.0;   // between a grid line's end and its label

// Outlines and knuckles nearer to the centre plane than this, mm, are the centre line itself.
inline constexpr double kOffCentre = 0.05;

struct PlanNeeds {
  HullExtents extents;
  PaperSize paper;
  std::optional<double> scale_denominator;  // the one wanted
  double label_column;                      // width of the widest label beside a grid, mm
  bool has_frames;
  Eigen::Vector2d title_block;
  // The sizes of the forms that the table of offsets can take; none without a table.
  std::vector<Eigen::Vector2d> tables;
  PlanViews views = {};
};

// An empty sheet: paper, frame, scale, views, table and title block.
//
// Of the usual scales (1, 2, 2.5, 5 and, as rulers have them too, 1.25, 3 and 7.5 times a power of
// ten) it is the largest at which everything
// fits in one of the arrangements of plan_arrangements.h; or the one wanted. Throws
// std::invalid_argument with the remedy if it does not fit.
LinesSheet choose_layout(const PlanNeeds& needs);

// "1:200", or "5:1" for an enlargement.
std::string scale_text(double denominator);

}  // namespace hull::drawing

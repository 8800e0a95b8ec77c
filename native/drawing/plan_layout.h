// SPDX-License-Identifier: GPL-3.0-or-later
// The scale of a lines plan and the places of its views on the paper.
#pragma once

#include <Eigen/Core>
#include <string>

#include "drawing/lines_drawing.h"

namespace hull {

// The box in ship axes that every view shows, in metres; breadth is measured from the centre plane.
struct HullExtents {
  double aft, fore;
  double breadth;
  double bottom, top;
  double midship;
};

// The extents of all curves, with the base line and the perpendiculars where they are near the
// hull. Throws as lay_out_lines.
HullExtents hull_extents(const LinesDrawing& drawing);

// Room kept around the hull itself in its views, in millimetres.
inline constexpr double kOverhang = 4.0;  // grid lines beyond the hull
inline constexpr double kSideOverhang =
    9.0;                                  // the same at the sides of the body plan: station labels
inline constexpr double kFanRow = 9.0;    // above the body plan: more station labels
inline constexpr double kLabelRow = 5.0;  // a row of labels above or below the grid
inline constexpr double kCaptionRow = 7.0;  // the name of the view
inline constexpr double kColumnGap = 1.0;   // between a grid line's end and its label

// Outlines and knuckles nearer to the centre plane than this, mm, are the centre line itself.
inline constexpr double kOffCentre = 0.05;

// An empty sheet: paper, frame, scale, views and title block. `label_column` is the width of the
// widest label at the ends of horizontal grid lines.
//
// Of the usual scales (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5, 8 times a power of ten) it is the
// largest at which everything fits, either with the three views one above the other, or with the
// body plan beside the profile on one base line.
LinesSheet choose_layout(const HullExtents& extents, Paper paper, double label_column,
                         const Eigen::Vector2d& title_block);

// "1:200", or "5:1" for an enlargement.
std::string scale_text(double denominator);

}  // namespace hull

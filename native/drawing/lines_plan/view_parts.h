// SPDX-License-Identifier: GPL-3.0-or-later
// What the three views of a lines plan have in common: grid lines with their labels, and labels on
// curves.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drawing/lines_plan/hull_extents.h"
#include "drawing/lines_plan/lines_drawing.h"
#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

// The part of a view's plane that the grid covers, in page mm.
using GridBox = Eigen::AlignedBox2d;

// A label at the end of a grid line.
struct Tick {
  double at;  // page x of a vertical line, page y of a horizontal one
  std::string text;
  Ink ink;
  bool first;  // gets its place before the others
};

// How a family of lines is drawn as curves, and its labels.
struct LineFamily {
  const Pen& pen;
  Ink ink;
};
inline constexpr LineFamily kStationLines{pens::kStation, inks::kStation};
inline constexpr LineFamily kWaterlineLines{pens::kWaterline, inks::kWaterline};
inline constexpr LineFamily kButtockLines{pens::kButtock, inks::kButtock};
inline constexpr LineFamily kDiagonalLines{pens::kDiagonal, inks::kDiagonal};

// How a view shows ship coordinates: the page point linear * p + shift.
struct Projection {
  Eigen::Matrix<double, 2, 3> linear;
  Eigen::Vector2d shift;
};

// The projection in which the view's coordinates to the right and up are right·p and up·p.
Projection projection(const View& view, const Eigen::RowVector3d& right,
                      const Eigen::RowVector3d& up);

// A curve on the page and its number as an obstacle (SheetBuilder::draw_curve).
struct PlacedCurve {
  PagePath path;
  int number;
};

// Draws the curve, and its spline if it has one.
PlacedCurve draw_ship_curve(SheetBuilder& builder, const Pen& pen, const Projection& shown,
                            const ShipCurve& curve);

// Midship's line and the perpendiculars within the extents; with `labelled` their names above the
// grid.
void draw_perpendiculars(SheetBuilder& builder, const View& view, const GridBox& grid,
                         const LinesDrawing& drawing, const HullExtents& extents, bool labelled);

void draw_caption(SheetBuilder& builder, const View& view, const std::string& text);

// Lines across the whole grid at a page coordinate.
void draw_vertical(SheetBuilder& builder, const Pen& pen, const GridBox& grid, double x);
void draw_horizontal(SheetBuilder& builder, const Pen& pen, const GridBox& grid, double y);

// The labels of vertical lines in a row, centred at the page height `y`; of horizontal lines in a
// column left and right of the grid. A label that would touch another in its row or column is left
// out; of two, the one that is later in `ticks` or not first.
void label_verticals(SheetBuilder& builder, const View& view, std::vector<Tick> ticks, double y);
void label_horizontals(SheetBuilder& builder, const View& view, const GridBox& grid,
                       std::vector<Tick> ticks);

// Writes `text` into the longest of `curves`, along it and interrupting it, as near as there is
// room to one of the page abscissas `wanted`, the first ones before the later. Nothing is written
// when there is no room.
void label_on_curve(SheetBuilder& builder, const View& view, const std::vector<PlacedCurve>& curves,
                    const std::string& text, Ink ink, const std::vector<double>& wanted);

// Whether this waterline is the design waterline.
bool is_design_waterline(const LinesDrawing& drawing, const NamedCurves& waterline);

// Grid lines and labels of the stations, which the profile and the half-breadth plan share; those
// beyond the extents are left out.
void draw_stations(SheetBuilder& builder, const View& view, const GridBox& grid,
                   const LinesDrawing& drawing, const HullExtents& extents);

// Grid lines and ticks of the waterlines, the base line and the design waterline, which the profile
// and the body plan share; those outside the view's heights are left out.
void draw_heights(SheetBuilder& builder, const View& view, const GridBox& grid,
                  const LinesDrawing& drawing, double bottom, double top);

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/lines_views.h"
#include "drawing/lines_plan/ship_curve.h"
#include "drawing/lines_plan/view_parts.h"

namespace hull::drawing {

namespace {

GridBox half_breadth_grid(const View& view, const HullExtents& extents) {
  // Diagonals are below the centre line, where y is negative.
  GridBox grid(view.to_page(extents.aft, extents.breadth),
               view.to_page(extents.fore, -extents.diagonals));
  grid.min() -= Eigen::Vector2d::Constant(kOverhang);
  grid.max() += Eigen::Vector2d::Constant(kOverhang);
  return grid;
}

void draw_grid(SheetBuilder& builder, const View& view, const GridBox& grid,
               const LinesDrawing& drawing, const HullExtents& extents) {
  draw_stations(builder, view, grid, drawing, extents);
  std::vector<Tick> offsets;
  for (const NamedCurves& buttock : drawing.buttocks) {
    if (buttock.position <= 0.0 || buttock.position > extents.breadth) continue;
    const double y = view.to_page(0.0, buttock.position).y();
    draw_horizontal(builder, pens::kGrid, grid, y);
    offsets.push_back({y, buttock.label, inks::kButtock, false});
  }
  const double centre = view.to_page(0.0, 0.0).y();
  draw_horizontal(builder, pens::kCentreLine, grid, centre);
  offsets.push_back({centre, "CL", inks::kBlack, true});
  label_horizontals(builder, view, grid, std::move(offsets));
}

// What lies in the centre plane is the centre line, which is drawn already.
void draw_off_centre(SheetBuilder& builder, const View& view, const Pen& pen, const Projection& top,
                     const std::vector<ShipCurve>& curves) {
  for (const ShipCurve& curve : curves) {
    for (const ShipCurve& part : parts_off_centre(curve, kOffCentre / view.scale)) {
      draw_ship_curve(builder, pen, top, part);
    }
  }
}

using Placed = std::vector<std::vector<PlacedCurve>>;

Placed draw_waterlines(SheetBuilder& builder, const Projection& top, const LinesDrawing& drawing) {
  Placed waterlines;
  for (const NamedCurves& waterline : drawing.waterlines) {
    std::vector<PlacedCurve>& placed = waterlines.emplace_back();
    const bool design = is_design_waterline(drawing, waterline);
    const Pen& pen = design ? pens::kLoadWaterline : kWaterlineLines.pen;
    for (const ShipCurve& curve : waterline.curves) {
      placed.push_back(draw_ship_curve(builder, pen, top, curve));
    }
  }
  return waterlines;
}

// Below the centre line, at their distance from it in their planes.
Placed draw_developed_diagonals(SheetBuilder& builder, const View& view,
                                const LinesDrawing& drawing) {
  Placed diagonals;
  for (const NamedDiagonal& member : drawing.diagonals) {
    std::vector<PlacedCurve>& placed = diagonals.emplace_back();
    // The distance along the plane is the half-breadth over the cosine of the angle, so one factor
    // does for all points.
    const double stretch = expanded(member.diagonal, {0.0, 1.0, 0.0});
    const Projection flat = projection(view, {1.0, 0.0, 0.0}, {0.0, -stretch, 0.0});
    for (const ShipCurve& curve : member.curves) {
      placed.push_back(draw_ship_curve(builder, kDiagonalLines.pen, flat, curve));
    }
  }
  return diagonals;
}

}  // namespace

void draw_half_breadth(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                       const HullExtents& extents) {
  const GridBox grid = half_breadth_grid(view, extents);
  const bool has_diagonals = extents.diagonals > 0.0;
  draw_caption(builder, view,
               has_diagonals ? "Half-breadth plan, diagonals expanded" : "Half-breadth plan");
  draw_grid(builder, view, grid, drawing, extents);
  // Their names stand above the profile, with which this view is in line.
  draw_perpendiculars(builder, view, grid, drawing, extents, false);

  const Projection top = projection(view, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  const Placed waterlines = draw_waterlines(builder, top, drawing);
  draw_off_centre(builder, view, pens::kKnuckle, top, drawing.knuckles);
  draw_off_centre(builder, view, pens::kOutline, top, drawing.outlines);
  const Placed diagonals = draw_developed_diagonals(builder, view, drawing);

  const double length = extents.fore - extents.aft;
  // In the ends, where the lines are apart; forward first.
  const std::vector<double> wanted = {view.to_page(extents.aft + 0.85 * length, 0.0).x(),
                                      view.to_page(extents.aft + 0.15 * length, 0.0).x()};
  for (std::size_t i = 0; i < waterlines.size(); ++i) {
    label_on_curve(builder, view, waterlines[i], drawing.waterlines[i].label, kWaterlineLines.ink,
                   wanted);
  }
  for (std::size_t i = 0; i < diagonals.size(); ++i) {
    label_on_curve(builder, view, diagonals[i], drawing.diagonals[i].label, kDiagonalLines.ink,
                   wanted);
  }
}

}  // namespace hull::drawing

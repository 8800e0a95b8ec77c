// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_views.h"
#include "drawing/ship_curve.h"
#include "drawing/view_parts.h"

namespace hull {

namespace {

PagePath top_view(const View& view, const ShipCurve& curve) {
  PagePath path;
  for (const Eigen::Vector3d& point : curve) path.push_back(view.to_page(point.x(), point.y()));
  return path;
}

GridBox grid_of(const View& view, const HullExtents& extents) {
  GridBox grid(view.to_page(extents.aft, extents.breadth), view.to_page(extents.fore, 0.0));
  grid.min() -= Eigen::Vector2d::Constant(kOverhang);
  grid.max() += Eigen::Vector2d::Constant(kOverhang);
  return grid;
}

void draw_grid(SheetBuilder& builder, const View& view, const GridBox& grid,
               const LinesDrawing& drawing, const HullExtents& extents) {
  std::vector<Tick> stations;
  for (const NamedCurves& station : drawing.stations) {
    if (station.position < extents.aft || station.position > extents.fore) continue;
    const double x = view.to_page(station.position, 0.0).x();
    draw_vertical(builder, pens::kGrid, grid, x);
    stations.push_back({x, station.label, inks::kStation, false});
  }
  label_verticals(builder, view, std::move(stations), grid.max().y() + 0.5 * kLabelRow);

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
void draw_off_centre(SheetBuilder& builder, const View& view, const Pen& pen,
                     const std::vector<ShipCurve>& curves) {
  for (const ShipCurve& curve : curves) {
    for (const ShipCurve& part : part_of_curve(curve, 1, kOffCentre / view.scale, Side::kAbove)) {
      builder.draw_curve(pen, top_view(view, part));
    }
  }
}

}  // namespace

void draw_half_breadth(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                       const HullExtents& extents) {
  const GridBox grid = grid_of(view, extents);
  draw_caption(builder, view, "Half-breadth plan");
  draw_grid(builder, view, grid, drawing, extents);

  std::vector<std::vector<PlacedCurve>> waterlines;
  for (const NamedCurves& waterline : drawing.waterlines) {
    std::vector<PlacedCurve>& placed = waterlines.emplace_back();
    const bool design = is_design_waterline(drawing, waterline);
    for (const ShipCurve& curve : waterline.curves) {
      PagePath path = top_view(view, curve);
      const Pen& pen = design ? pens::kLoadWaterline : kWaterlineLines.pen;
      placed.push_back({path, builder.draw_curve(pen, path)});
    }
  }
  draw_off_centre(builder, view, pens::kKnuckle, drawing.knuckles);
  draw_off_centre(builder, view, pens::kOutline, drawing.outlines);

  const double length = extents.fore - extents.aft;
  const std::vector<double> wanted = {view.to_page(extents.aft + 0.85 * length, 0.0).x(),
                                      view.to_page(extents.aft + 0.15 * length, 0.0).x()};
  for (std::size_t i = 0; i < waterlines.size(); ++i) {
    label_on_curve(builder, view, waterlines[i], drawing.waterlines[i].label, kWaterlineLines.ink,
                   wanted);
  }
}

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/frame_scale.h"
#include "drawing/lines_plan/lines_views.h"
#include "drawing/lines_plan/view_parts.h"

namespace hull::drawing {

namespace {

GridBox profile_grid(const View& view, const HullExtents& extents) {
  // Upper left and lower right, as y runs down the page.
  GridBox grid(view.to_page(extents.aft, extents.top), view.to_page(extents.fore, extents.bottom));
  grid.min() -= Eigen::Vector2d::Constant(kOverhang);
  grid.max() += Eigen::Vector2d::Constant(kOverhang);
  return grid;
}

}  // namespace

void draw_profile(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                  const HullExtents& extents) {
  const GridBox grid = profile_grid(view, extents);
  draw_caption(builder, view, "Profile");
  draw_stations(builder, view, grid, drawing, extents);
  draw_heights(builder, view, grid, drawing, extents.bottom, extents.top);
  draw_perpendiculars(builder, view, grid, drawing, extents, true);
  if (drawing.frame_spacing || drawing.frames) {
    draw_frame_scale(builder, view, grid, drawing, extents);
  }

  const Projection side = projection(view, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  std::vector<std::vector<PlacedCurve>> buttocks;
  for (const NamedCurves& buttock : drawing.buttocks) {
    std::vector<PlacedCurve>& placed = buttocks.emplace_back();
    for (const ShipCurve& curve : buttock.curves) {
      placed.push_back(draw_ship_curve(builder, kButtockLines.pen, side, curve));
    }
  }
  for (const ShipCurve& curve : drawing.knuckles) {
    draw_ship_curve(builder, pens::kKnuckle, side, curve);
  }
  for (const ShipCurve& curve : drawing.outlines) {
    draw_ship_curve(builder, pens::kOutline, side, curve);
  }

  // The buttocks are apart from one another in the ends of the ship.
  const double length = extents.fore - extents.aft;
  const std::vector<double> wanted = {view.to_page(extents.aft + 0.82 * length, 0.0).x(),
                                      view.to_page(extents.aft + 0.15 * length, 0.0).x()};
  for (std::size_t i = 0; i < buttocks.size(); ++i) {
    label_on_curve(builder, view, buttocks[i], drawing.buttocks[i].label, kButtockLines.ink,
                   wanted);
  }
}

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
// The three views of a lines plan, each drawn into its place on the sheet (plan_layout.h).
#pragma once

#include "drawing/lines_plan/lines_drawing.h"
#include "drawing/lines_plan/plan_layout.h"
#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

// Seen from starboard: x to the right, z up. Buttocks, outlines and knuckles as curves; stations
// and waterlines as straight lines; base line and perpendiculars, the scale of frames.
void draw_profile(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                  const HullExtents& extents);

// The port half seen from above: x to the right, y up. Waterlines, outlines and knuckles as curves;
// stations and buttocks as straight lines; below the centre line the diagonals, expanded.
void draw_half_breadth(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                       const HullExtents& extents);

// The after half sections to the left of the centre line, the fore ones to the right, z up;
// waterlines, buttocks and diagonals as straight lines.
void draw_body_plan(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                    const HullExtents& extents);

}  // namespace hull::drawing

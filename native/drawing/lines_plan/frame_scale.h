// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawing/lines_plan/hull_extents.h"
#include "drawing/lines_plan/view_parts.h"

namespace hull::drawing {

// The frames as marks on a line below the profile's labels, with their distance at its end: frame 0
// at x = 0, numbers rising forward. As many are numbered as there is room for, always every so
// many; marks that would be nearer than half a millimetre are only drawn where there is a number.
// REQUIRES: drawing.frame_spacing or frames.
void draw_frame_scale(SheetBuilder& builder, const View& view, const GridBox& grid,
                      const LinesDrawing& drawing, const HullExtents& extents);

}  // namespace hull::drawing

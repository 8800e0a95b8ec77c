// SPDX-License-Identifier: GPL-3.0-or-later
// The title block in the lower right corner: title, scale, the rows below the title,
// particulars, scale bar.
#pragma once

#include <Eigen/Core>

#include "drawing/lines_plan/lines_drawing.h"
#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

// Width and height in mm. Throws std::invalid_argument for more than kMostParticulars or
// kMostTitleRows.
Eigen::Vector2d title_block_size(const LinesDrawing& drawing);

// Draws it into `sheet.title_block`; `sheet` gives the scale as well.
void draw_title_block(SheetBuilder& builder, const LinesSheet& sheet, const LinesDrawing& drawing);

}  // namespace hull::drawing

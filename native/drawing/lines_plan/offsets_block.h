// SPDX-License-Identifier: GPL-3.0-or-later
// The table of offsets on the sheet.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "drawing/lines_plan/lines_drawing.h"
#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

// The sizes, mm, of the forms that the table of `drawing.offsets` can take, the ones wanted most
// first: with a row for each station or a column for each, in letters large and small. Empty
// without offsets.
std::vector<Eigen::Vector2d> offsets_block_sizes(const LinesDrawing& drawing);

// Draws it in one of these forms into a box of that size.
void draw_offsets_block(SheetBuilder& builder, const Eigen::AlignedBox2d& box,
                        const LinesDrawing& drawing, int form);

}  // namespace hull::drawing

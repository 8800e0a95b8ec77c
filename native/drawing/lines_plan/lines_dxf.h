// SPDX-License-Identifier: GPL-3.0-or-later
// A lines plan for CAD systems.
#pragma once

#include <string>

#include "drawing/lines_plan/lines_sheet.h"
#include "dxf/dxf_file.h"

namespace hull::drawing {

// The sheet at the ship's true size, in the unit: the profile's coordinates are the ship's x and z,
// the other views, tables and texts lie around it as on paper. Each kind of line is on a layer of
// its own (the pens' layers, pens.h), texts are on TEXT; colours and widths are the layers'. Curves
// whose spline is known are splines, the others polylines. Labels that interrupt a curve on paper
// stand above it.
dxf::DxfDrawing lines_dxf(const LinesSheet& sheet, dxf::DxfUnit unit);

// Throws as write_dxf (dxf/dxf_file.h).
void write_lines_dxf(const LinesSheet& sheet, dxf::DxfUnit unit, const std::string& path);

}  // namespace hull::drawing

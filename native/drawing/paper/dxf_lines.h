// SPDX-License-Identifier: GPL-3.0-or-later
// Pens of paper as DXF files have them.
#pragma once

#include "drawing/paper/sheet.h"
#include "dxf/dxf_file.h"

namespace hull::drawing {

inline dxf::DxfLineType dxf_line_type(const Dashes& dashes) {
  if (dashes == Dashes{}) return dxf::DxfLineType::kContinuous;
  // Equal dashes, or long and short ones in turn.
  return dashes[0] == dashes[2] ? dxf::DxfLineType::kDashed : dxf::DxfLineType::kCentre;
}

}  // namespace hull::drawing

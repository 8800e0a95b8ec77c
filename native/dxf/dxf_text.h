// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hull::dxf {

// `text` (UTF-8) as a DXF file holds it: letters beyond ASCII as \U+XXXX, those beyond the first
// 65536 and bytes that are no UTF-8 as '?', controls as blanks, and a '^' or '%%' that would begin
// a control code broken up.
std::string encode_dxf_text(std::string_view text);

}  // namespace hull::dxf

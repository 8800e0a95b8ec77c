// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hull::exchange {

// A UTF-8 string as the inside of a STEP string literal (ISO 10303-21, 6.4.3): apostrophes and
// backslashes doubled, characters outside printable ASCII as \X2\hhhh\X0\ or \X4\hhhhhhhh\X0\,
// control characters as a space. Bytes that are not UTF-8 become '?'.
std::string encode_step_string(std::string_view utf8);

// The reverse, for what encode_step_string writes; other directives are left as they are.
std::string decode_step_string(std::string_view text);

}  // namespace hull::exchange

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hull::exchange {

// The text of a STEP file (ISO 10303-21) with as few characters as mean the same: numbers with a
// point as the shortest ones that are read as the same doubles, no space between tokens, and a new
// line after every semicolon and where lines would grow beyond 100 characters. Strings stay as they
// are. REQUIRES: no comments.
std::string short_step(std::string_view text);

}  // namespace hull::exchange

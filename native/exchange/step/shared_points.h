// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hull::exchange {

// The text of a STEP file in which points with equal names and coordinates are one entity: control
// points on borders are those of an edge's curve too, and of the neighbouring face where that has
// the same. What referred to another of them refers to the first. Numbers of entities stay, so that
// some are missing. REQUIRES: text as of short_step().
std::string with_shared_points(std::string_view text);

}  // namespace hull::exchange

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace hull::analysis {

inline constexpr double kDegree = std::numbers::pi / 180.0;  // rad

}  // namespace hull::analysis

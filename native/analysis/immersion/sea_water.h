// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::analysis {

inline constexpr double kSeaWaterDensity = 1.025;  // t/m³, at 15 °C: the default of all functions

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace hull::analysis {

// The ordinates that were published for the 63-, 64- and 65-series (Abbott, Doenhoff & Stivers
// 1945) at 6, 9, 12, 15, 18 and 21 % of the chord, and for the 63A-, 64A- and 65A-series (Loftin
// 1948) at 6, 8, 10, 12 and 15 %: the sources give no formula.
constexpr int kTableStations = 26;
constexpr std::array<double, kTableStations> kTableX{
    0.0, 0.005, 0.0075, 0.0125, 0.025, 0.05, 0.075, 0.1,  0.15, 0.2,  0.25, 0.3,  0.35,
    0.4, 0.45,  0.5,    0.55,   0.6,   0.65, 0.7,   0.75, 0.8,  0.85, 0.9,  0.95, 1.0};

// Half thickness over √x at the stations, of the chord; at the leading edge √(2 r) with the radius
// r there. In parts of the thickness it is a cubic through those of the four nearest published ones
// (at these they come out), beyond the thinnest and the thickest it is theirs.
// family: 63, 64, 65.
std::array<double, kTableStations> series_ratios(int family, bool is_6a, double thickness);

}  // namespace hull::analysis

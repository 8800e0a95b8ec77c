// SPDX-License-Identifier: GPL-3.0-or-later
// The pens and inks of drawings: what each kind of line looks like, on every sheet the same.
#pragma once

#include "drawing/paper/sheet.h"

namespace hull::drawing {

// Dark enough to print well in grey, apart enough to tell the families in colour.
namespace inks {
inline constexpr Ink kBlack{0.0, 0.0, 0.0};
inline constexpr Ink kGrey{0.42, 0.42, 0.42};
inline constexpr Ink kPaleGrey{0.72, 0.72, 0.72};
inline constexpr Ink kStation{0.07, 0.22, 0.55};
inline constexpr Ink kWaterline{0.03, 0.38, 0.26};
inline constexpr Ink kButtock{0.62, 0.12, 0.10};
inline constexpr Ink kDiagonal{0.45, 0.14, 0.50};
}  // namespace inks

namespace pens {
inline constexpr Dashes kChain{6.0, 1.2, 0.8, 1.2};
inline constexpr Pen kFrame{0.50, inks::kBlack, {}, "FRAME"};
inline constexpr Pen kTable{0.18, inks::kBlack, {}, "TABLES"};
inline constexpr Pen kGrid{0.10, inks::kPaleGrey, {}, "GRID"};
inline constexpr Pen kFrameScale{0.13, inks::kGrey, {}, "FRAME_SPACING"};
inline constexpr Pen kBaseline{0.25, inks::kBlack, {}, "BASE_LINE"};
inline constexpr Pen kCentreLine{0.13, inks::kBlack, kChain, "CENTRE_LINE"};
inline constexpr Pen kMidship{0.18, inks::kBlack, {4.0, 1.0, 0.6, 1.0}, "MIDSHIP"};
inline constexpr Pen kPerpendicular{0.18, inks::kBlack, {4.0, 1.0, 0.6, 1.0}, "PERPENDICULARS"};
// The straight trace of the design waterline, and the design waterline as a curve, heavier than its
// neighbours.
inline constexpr Pen kDesignWaterline{0.30, inks::kWaterline, {}, "DESIGN_WATERLINE"};
inline constexpr Pen kLoadWaterline{0.40, inks::kWaterline, {}, "DESIGN_WATERLINE"};
inline constexpr Pen kStation{0.20, inks::kStation, {}, "STATIONS"};
inline constexpr Pen kMidshipSection{0.35, inks::kStation, {}, "STATIONS"};
inline constexpr Pen kWaterline{0.20, inks::kWaterline, {}, "WATERLINES"};
inline constexpr Pen kButtock{0.20, inks::kButtock, {}, "BUTTOCKS"};
inline constexpr Pen kDiagonal{0.20, inks::kDiagonal, {}, "DIAGONALS"};
// A diagonal's straight trace in the body plan.
inline constexpr Pen kDiagonalTrace{0.13, inks::kDiagonal, {3.0, 1.0, 3.0, 1.0}, "DIAGONAL_TRACES"};
inline constexpr Pen kKnuckle{0.32, inks::kBlack, {}, "KNUCKLES"};
inline constexpr Pen kOutline{0.45, inks::kBlack, {}, "OUTLINE"};
inline constexpr Pen kLeader{0.10, inks::kGrey, {}, "TEXT"};
}  // namespace pens

}  // namespace hull::drawing

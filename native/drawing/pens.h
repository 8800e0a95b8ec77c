// SPDX-License-Identifier: GPL-3.0-or-later
// The pens and inks of drawings: what each kind of line looks like, on every sheet the same.
#pragma once

#include "drawing/sheet.h"

namespace hull {

// Dark enough to print well in grey, apart enough to tell the families in colour.
namespace inks {
inline constexpr Colour kBlack{0.0, 0.0, 0.0};
inline constexpr Colour kGrey{0.42, 0.42, 0.42};
inline constexpr Colour kPaleGrey{0.72, 0.72, 0.72};
inline constexpr Colour kStation{0.07, 0.22, 0.55};
inline constexpr Colour kWaterline{0.03, 0.38, 0.26};
inline constexpr Colour kButtock{0.62, 0.12, 0.10};
}  // namespace inks

namespace pens {
inline constexpr Pen kFrame{0.50, inks::kBlack};
inline constexpr Pen kTable{0.18, inks::kBlack};
inline constexpr Pen kGrid{0.10, inks::kPaleGrey};
inline constexpr Pen kBaseline{0.25, inks::kBlack};
inline constexpr Pen kCentreLine{0.13, inks::kBlack, {6.0, 1.2, 0.8, 1.2}};
inline constexpr Pen kPerpendicular{0.18, inks::kBlack, {4.0, 1.0, 0.6, 1.0}};
// The straight trace of the design waterline, and the design waterline as a curve, heavier than its
// neighbours.
inline constexpr Pen kDesignWaterline{0.30, inks::kWaterline};
inline constexpr Pen kLoadWaterline{0.40, inks::kWaterline};
inline constexpr Pen kStation{0.20, inks::kStation};
inline constexpr Pen kWaterline{0.20, inks::kWaterline};
inline constexpr Pen kButtock{0.20, inks::kButtock};
inline constexpr Pen kKnuckle{0.32, inks::kBlack};
inline constexpr Pen kOutline{0.45, inks::kBlack};
inline constexpr Pen kLeader{0.10, inks::kGrey};
}  // namespace pens

}  // namespace hull

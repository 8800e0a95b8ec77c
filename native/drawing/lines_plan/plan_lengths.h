// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths as a lines plan writes them: in metres, its table of offsets in millimetres; or in
// decimal feet, and there in feet, inches and eighths, as American lofts have them.
#pragma once

#include <string>
#include <vector>

namespace hull::drawing {

enum class LengthUnit { kMetre, kFoot };

double metres_of(LengthUnit unit);
std::string symbol_of(LengthUnit unit);  // "m"
std::string plural_of(LengthUnit unit);  // "metres"

// The fewest decimals, from 1 to 3, that tell lengths in metres to half a millimetre, or to half a
// thousandth of a foot.
int decimals_of(const std::vector<double>& metres, LengthUnit unit);

// "2.0 m" of a length in metres.
std::string length_text(double metres, int decimals, LengthUnit unit);

// "600 mm", "24 in" of a spacing of frames in metres.
std::string spacing_text(double metres, LengthUnit unit);

// "2.0 m" -> "2.0".
std::string without_unit(const std::string& text, LengthUnit unit);

// An offset in metres in a table: "1234" millimetres; "4-0-4+" feet, inches and eighths, + a
// sixteenth more. "–" for none, not a number.
std::string offset_text(double metres, LengthUnit unit);
std::string offsets_unit(LengthUnit unit);  // "mm", "feet-inches-eighths"

}  // namespace hull::drawing

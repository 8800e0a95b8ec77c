// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::resistance {

// The frictional resistance coefficient of the ITTC 1957 model–ship correlation line,
// CF = 0.075 / (log10 Rn - 2)², on the wetted surface. Throws std::invalid_argument unless the
// Reynolds number is finite and above 1,000: the line has a pole at 100.
double ittc_1957(double reynolds_number);

}  // namespace hull::resistance

// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/friction_line.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hull::resistance {

double ittc_1957(double reynolds_number) {
  if (!(reynolds_number > 1000.0) || !std::isfinite(reynolds_number)) {
    throw std::invalid_argument("The Reynolds number " + std::to_string(reynolds_number) +
                                " has no friction coefficient on the ITTC line: it must be above "
                                "1000; give a speed above zero, a length and a viscosity.");
  }
  const double exponent = std::log10(reynolds_number) - 2.0;
  return 0.075 / (exponent * exponent);
}

}  // namespace hull::resistance

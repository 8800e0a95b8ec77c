// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/place_text.h"

#include <cmath>
#include <cstdio>

namespace hull::mesh {

std::string place_text(const Vector3d& place, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  std::string text = "(";
  for (int axis = 0; axis < 3; ++axis) {
    const double shown = std::abs(place[axis]) < half ? 0.0 : place[axis];
    // As long as the largest number, its sign, its point and its decimals.
    char number[330];
    std::snprintf(number, sizeof number, "%s%.*f", axis > 0 ? ", " : "", decimals, shown);
    text += number;
  }
  return text + ")";
}

}  // namespace hull::mesh

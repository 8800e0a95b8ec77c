// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/network_problem.h"

#include <cstdio>

#include "mesh/place_text.h"

namespace hull::network {

std::string place_text(const Vector3d& place) { return mesh::place_text(place, 3) + " m"; }

std::string length_text(double length) {
  char text[60];
  // What rounds to a metre is one: it would be "1e+03 mm".
  if (length < 0.9995) {
    std::snprintf(text, sizeof text, "%.3g mm", 1000.0 * length);
  } else {
    std::snprintf(text, sizeof text, "%.3f m", length);
  }
  return text;
}

}  // namespace hull::network

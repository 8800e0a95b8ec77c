// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/network_problem.h"

#include <cstdio>

namespace hull::network {

std::string place_text(const Vector3d& place) {
  char text[120];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) m", place.x(), place.y(), place.z());
  return text;
}

std::string length_text(double length) {
  char text[60];
  if (length < 1.0) {
    std::snprintf(text, sizeof text, "%.3g mm", 1000.0 * length);
  } else {
    std::snprintf(text, sizeof text, "%.3f m", length);
  }
  return text;
}

}  // namespace hull::network

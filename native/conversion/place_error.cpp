// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/place_error.h"

#include <cstdio>

namespace hull::conversion {

std::string place_text(const Vector3d& point) {
  char text[100];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g) m", point.x(), point.y(), point.z());
  return text;
}

}  // namespace hull::conversion

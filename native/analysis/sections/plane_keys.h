// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// By which what is kept of a plane is found.
using PlaneKey = std::array<double, 4>;

inline std::vector<PlaneKey> keys_of(const std::vector<Plane>& planes) {
  std::vector<PlaneKey> keys;
  keys.reserve(planes.size());
  for (const Plane& plane : planes) {
    keys.push_back({plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset});
  }
  return keys;
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/port_side.h"

#include <algorithm>

namespace hull::analysis {
namespace {

constexpr double kNoise = 1e-3;  // across the centre plane, of the breadth

}  // namespace

std::string missing_port_side(const surface::LimitSurface& surface) {
  double port = 0.0, starboard = 0.0;
  for (const Vector3d& p : surface.mesh().points()) {
    port = std::max(port, p.y());
    starboard = std::max(starboard, -p.y());
  }
  if (starboard == 0.0 || port > kNoise * starboard) return {};
  return "The half hull lies to starboard (y < 0), but the half that counts twice is the port one: "
         "mirror it to port.";
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/port_side.h"

#include <algorithm>

namespace hull::analysis {
namespace {

// A half that reaches to port by at least this part of its reach to starboard is none to starboard:
// both sides are modelled, or the port one. As in hull_io's sides.py.
constexpr double kBothSides = 0.5;

// A whole hull that reaches to port by less than this part of its reach to starboard has nothing
// there: what is left is centre plane, however it was modelled.
constexpr double kNothingToPort = 1e-3;

}  // namespace

std::string missing_port_side(const surface::LimitSurface& surface, bool mirrored) {
  const Eigen::AlignedBox3d& box = surface.mesh().box();
  const double port = std::max(0.0, box.max().y()), starboard = std::max(0.0, -box.min().y());
  if (port >= (mirrored ? kBothSides : kNothingToPort) * starboard) return {};
  if (!mirrored) return "Nothing of the hull lies to port (y > 0): mirror it to port.";
  return "The half hull lies to starboard (y < 0), but the half that counts twice is the port one: "
         "mirror it to port.";
}

}  // namespace hull::analysis

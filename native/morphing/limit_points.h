// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull::morphing {

// The surface's points that belong to the control points; the point itself where no face has it.
inline std::vector<Vector3d> limit_points(const surface::LimitSurface& surface) {
  const mesh::Topology& topology = surface.mesh().topology();
  std::vector<Vector3d> points = surface.mesh().points();
  for (int v = 0; v < topology.vertex_count(); ++v) {
    const int h = topology.outgoing(v);
    if (h >= 0) points[v] = surface.position(h, 0.0, 0.0);
  }
  return points;
}

}  // namespace hull::morphing

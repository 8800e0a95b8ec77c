// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/limit_surface.h"

namespace hull::morphing {

struct LayoutDistances {
  double rms = 0.0, largest = 0.0;    // m
  Vector3d place = Vector3d::Zero();  // of the largest
};

// Of places all over a surface from another one; the root mean square by area.
LayoutDistances layout_distances(const surface::LimitSurface& from,
                                 const surface::LimitSurface& to);

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/surface_tree.h"

namespace hull::morphing {

struct LayoutDistances {
  double rms = 0.0, largest = 0.0;    // m
  Vector3d place = Vector3d::Zero();  // of the largest
};

// The feet of places all over a surface on another one.
std::vector<surface::ClosestPoint> layout_feet(const modelling::SurfacePlaces& places,
                                               const surface::SurfaceTree& to);

// Of the places from their feet; the root mean square by area.
LayoutDistances layout_distances(const modelling::SurfacePlaces& places,
                                 const std::vector<surface::ClosestPoint>& feet);
// Of places all over a surface from another one.
LayoutDistances layout_distances(const surface::LimitSurface& from,
                                 const surface::LimitSurface& to);

}  // namespace hull::morphing

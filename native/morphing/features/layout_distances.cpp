// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_distances.h"

#include <cmath>

namespace hull::morphing {

std::vector<surface::ClosestPoint> layout_feet(const modelling::SurfacePlaces& places,
                                               const surface::SurfaceTree& to) {
  std::vector<Vector3d> points;
  for (int k = 0; k < places.count(); ++k) points.push_back(places.position(k));
  return surface::closest_points(to, points);
}

LayoutDistances layout_distances(const modelling::SurfacePlaces& places,
                                 const std::vector<surface::ClosestPoint>& feet) {
  LayoutDistances found;
  double sum = 0.0;
  for (int k = 0; k < places.count(); ++k) {
    const double distance = feet[k].distance;
    // Each place stands for the surface around it.
    sum += places.area(k) * distance * distance;
    if (distance <= found.largest) continue;
    found.largest = distance;
    found.place = places.position(k);
  }
  found.rms = std::sqrt(sum / places.total_area());
  return found;
}

LayoutDistances layout_distances(const surface::LimitSurface& from,
                                 const surface::LimitSurface& to) {
  const modelling::SurfacePlaces places(from);
  return layout_distances(places, layout_feet(places, surface::SurfaceTree(to)));
}

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_distances.h"

#include <cmath>
#include <vector>

#include "modelling/reshape/surface_places.h"
#include "surface/queries/closest_point.h"

namespace hull::morphing {

LayoutDistances layout_distances(const surface::LimitSurface& from,
                                 const surface::LimitSurface& to) {
  const modelling::SurfacePlaces places(from);
  std::vector<Vector3d> points;
  for (int k = 0; k < places.count(); ++k) points.push_back(places.position(k));
  const std::vector<surface::ClosestPoint> feet =
      surface::closest_points(surface::SurfaceTree(to), points);
  LayoutDistances found;
  double sum = 0.0;
  for (int k = 0; k < places.count(); ++k) {
    const double distance = feet[k].distance;
    sum += places.area(k) * distance * distance;
    if (distance <= found.largest) continue;
    found.largest = distance;
    found.place = points[k];
  }
  found.rms = std::sqrt(sum / places.total_area());
  return found;
}

}  // namespace hull::morphing

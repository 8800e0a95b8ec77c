// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/centre_line.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mesh/centre_plane.h"
#include "mesh/tolerances.h"

namespace hull::conversion {

std::optional<surface::LimitSurface> with_centre_line(const surface::LimitSurface& surface) {
  std::vector<Vector3d> points = mesh::points_with_centre_line(surface.mesh());
  if (points == surface.mesh().points()) return std::nullopt;
  surface::LimitSurface moved = surface;
  moved.set_points(std::move(points));
  return moved;
}

PatchSource source_of(const surface::LimitSurface& surface) {
  PatchSource source{std::make_shared<const std::vector<Vector3d>>(surface.mesh().points()), {}};
  for (int v : mesh::vertices_near_centre_line(surface.mesh())) {
    source.near_centre_line.push_back((*source.points)[v]);
  }
  return source;
}

void refuse_near_centre_line(const std::vector<Vector3d>& points, double size) {
  if (points.empty()) return;
  const Vector3d& farthest = *std::ranges::max_element(
      points, {}, [](const Vector3d& point) { return std::abs(point.y()); });
  std::ostringstream words;
  words << std::fixed << std::setprecision(3)
        << (points.size() == 1 ? std::string("a control point")
                               : std::to_string(points.size()) + " control points")
        << " of the border along the centre line " << (points.size() == 1 ? "is" : "are")
        << " off the centre plane, by up to " << 1e3 * std::abs(farthest.y()) << " mm at ("
        << farthest.x() << ", " << farthest.y() << ", " << farthest.z()
        << ") m, so that the two sides would not join; set y to 0 there, or to more than "
        << 1e3 * kNearCentrePlane * size << " mm if a gap is meant";
  throw std::invalid_argument(words.str());
}

}  // namespace hull::conversion

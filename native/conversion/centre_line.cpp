// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/centre_line.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include "conversion/place_error.h"
#include "mesh/centre_plane.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

struct OffPlane {
  Vector3d farthest;
  std::string words;  // how many points there are, and where the farthest is
};

OffPlane off_plane(const PatchSource& source, const std::vector<int>& vertices) {
  const auto distance = [&](int v) { return std::abs((*source.points)[v].y()); };
  const Vector3d& farthest = (*source.points)[*std::ranges::max_element(vertices, {}, distance)];
  const bool is_one = vertices.size() == 1;
  std::ostringstream words;
  words << std::fixed << std::setprecision(3)
        << (is_one ? "a control point" : std::to_string(vertices.size()) + " control points")
        << " of the border along the centre line " << (is_one ? "is" : "are")
        << " off the centre plane, by up to " << 1e3 * std::abs(farthest.y()) << " mm at "
        << place_text(farthest);
  return {farthest, words.str()};
}

}  // namespace

std::optional<surface::LimitSurface> with_centre_line(const surface::LimitSurface& surface) {
  std::vector<Vector3d> points = mesh::points_with_centre_line(surface.mesh());
  // The same to the last bit: no copy of the surface where there is nothing to move.
  if (points == surface.mesh().points()) return std::nullopt;
  // A copy shares the layout, so only points are computed again.
  surface::LimitSurface moved = surface;
  moved.set_points(std::move(points));
  return moved;
}

PatchSource source_of(const surface::LimitSurface& surface) {
  const mesh::ControlMesh& control = surface.mesh();
  return {std::make_shared<const std::vector<Vector3d>>(control.points()),
          mesh::vertices_near_centre_line(control), mesh::gaps_in_centre_line(control)};
}

void refuse_near_centre_line(const PatchSource& source, double size) {
  if (source.near_centre_line.empty()) return;
  const OffPlane off = off_plane(source, source.near_centre_line);
  std::ostringstream words;
  words << off.words << ", so that the two sides would not join; use Put on Centre Plane, or set "
        << "y to 0 there, or to more than " << std::fixed << std::setprecision(3)
        << 1e3 * kNearCentrePlane * size << " mm if a gap is meant";
  throw PlaceError(words.str(), off.farthest, source.near_centre_line);
}

std::string gap_warning(const PatchSource& source) {
  if (source.gaps.empty()) return "";
  return off_plane(source, source.gaps).words +
         ", while most of it is on it: the two sides are not joined there; set y to 0 there unless "
         "a gap is meant";
}

}  // namespace hull::conversion

// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/fair_limits.h"

#include <algorithm>
#include <stdexcept>

#include "modelling/complement.h"

namespace hull::modelling {
namespace {

// Of a unit normal's part across the ship: less has no direction.
constexpr double kNoNormal = 1e-6;

std::vector<int> unique_points(std::vector<int> points, int count) {
  if (points.empty()) throw std::invalid_argument("Choose the control points that are to move.");
  for (int point : points) check_point(point, count, "chosen");
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// What a chosen point may not move along.
void hold_across(const surface::LimitSurface& surface, const FairOptions& options, int point,
                 std::vector<HeldDirection>& held) {
  const mesh::Topology& t = surface.mesh().topology();
  if (options.keep_stations) held.push_back({point, Vector3d::UnitX()});
  if (!options.along_normals || t.kind(point) != mesh::VertexKind::kSmooth) return;
  // Cells begin at the corners of faces, in the order of half-edges.
  Vector3d normal = surface.normal(t.outgoing(point), 0.0, 0.0);
  // Its part across the ship: with x held the point has that one direction left.
  if (options.keep_stations) normal.x() = 0.0;
  if (!(normal.norm() > kNoNormal)) return;
  for (const Vector3d& across : complement<Vector3d>({normal}, 3)) held.push_back({point, across});
}

}  // namespace

ReshapeLimits fair_limits(const surface::LimitSurface& surface, const FairOptions& options) {
  if (!options.limits.prescribed.empty()) {
    throw std::invalid_argument("No moves can be prescribed where a region is faired.");
  }
  const mesh::Topology& t = surface.mesh().topology();
  const std::vector<int> chosen = unique_points(options.points, t.vertex_count());
  ReshapeLimits limits = options.limits;
  std::size_t next = 0;
  for (int point = 0; point < t.vertex_count(); ++point) {
    const bool is_chosen = next < chosen.size() && chosen[next] == point;
    if (is_chosen) ++next;
    const bool is_kept = options.keep_creases && t.kind(point) != mesh::VertexKind::kSmooth;
    if (!is_chosen || is_kept) {
      limits.limits.locked.push_back(point);
    } else {
      hold_across(surface, options, point, limits.limits.held);
    }
  }
  return limits;
}

}  // namespace hull::modelling

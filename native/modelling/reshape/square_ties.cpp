// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/square_ties.h"

#include <cmath>

#include "mesh/tolerances.h"

namespace hull::modelling {
namespace {

// The half-edge that leaves a border point of two quadrilaterals inwards; -1 at others. `h` leaves
// the point along the border.
int way_in(const mesh::Topology& t, int h) {
  const int inwards = t.prev(h);  // runs towards the point
  const int beside = t.twin(inwards);
  if (beside < 0 || t.is_crease(inwards) || t.twin(t.prev(beside)) >= 0) return -1;
  const bool are_quadrilaterals = t.face_size(t.face(h)) == 4 && t.face_size(t.face(beside)) == 4;
  return are_quadrilaterals && t.kind_at(h) == mesh::VertexKind::kCrease ? beside : -1;
}

}  // namespace

std::vector<TiedPoint> square_ties(const surface::LimitSurface& surface) {
  const mesh::Topology& t = surface.mesh().topology();
  const std::vector<Vector3d>& points = surface.mesh().points();
  const double near = kOnCentrePlane * surface.mesh().size();
  const auto is_in_plane = [&](int h) { return std::abs(points[t.origin(h)].y()) <= near; };
  std::vector<TiedPoint> ties;
  for (int h = 0; h < t.half_edge_count(); ++h) {
    if (t.twin(h) >= 0 || !is_in_plane(h) || !is_in_plane(t.next(h))) continue;
    const int inwards = way_in(t, h);
    // The border must come along the plane, too.
    if (inwards < 0 || !is_in_plane(t.prev(inwards))) continue;
    const int leader = t.origin(h), point = t.origin(t.next(inwards));
    const Vector3d step = points[point] - points[leader];
    if (std::abs(step.x()) > near || std::abs(step.z()) > near) continue;
    // Not along y: across the plane the neighbour is free.
    ties.push_back({point, leader, Vector3d::UnitX()});
    ties.push_back({point, leader, Vector3d::UnitZ()});
  }
  return ties;
}

}  // namespace hull::modelling

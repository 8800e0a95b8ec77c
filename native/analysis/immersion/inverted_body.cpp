// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/inverted_body.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Whether an edge of the body's border lies along the border of another: both its ends are where
// that has points of its own.
bool is_torn_off(const surface::LimitSurface& surface, const Bodies& bodies, int body) {
  const mesh::Topology& topology = surface.mesh().topology();
  const std::vector<Vector3d>& points = surface.mesh().points();
  const double same = kSamePosition * surface.mesh().size();
  std::vector<int> own;  // half-edges
  std::vector<Vector3d> others;
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    if (topology.twin(h) >= 0) continue;
    // Cells are numbered as the half-edges that they come from.
    if (bodies.of_cell[h] == body) {
      own.push_back(h);
    } else {
      others.push_back(points[topology.origin(h)]);
    }
  }
  const auto x_of = [](const Vector3d& point) { return point.x(); };
  std::ranges::sort(others, {}, x_of);
  const auto is_shared = [&](int v) {
    const Vector3d& point = points[v];
    auto other = std::ranges::lower_bound(others, point.x() - same, {}, x_of);
    for (; other != others.end() && other->x() <= point.x() + same; ++other) {
      if ((*other - point).norm() <= same) return true;
    }
    return false;
  };
  return std::ranges::any_of(own, [&](int h) {
    return is_shared(topology.origin(h)) && is_shared(topology.origin(topology.next(h)));
  });
}

}  // namespace

std::string inverted_body_text(const surface::LimitSurface& surface, const Bodies& bodies,
                               int body) {
  const int face = surface.mesh().topology().face(bodies.first_cell[body]);
  const std::string text = "The displaced volume is negative: the faces of the body with face " +
                           std::to_string(face) + " are turned inwards";
  if (!is_torn_off(surface, bodies, body)) {
    return text + ". Turn them outwards, into the water: Turn Faces Outwards does that.";
  }
  return text +
         ", or torn off another body, along whose border theirs lies. There "
         "join the points that are there twice: Join Points does that.";
}

}  // namespace hull::analysis

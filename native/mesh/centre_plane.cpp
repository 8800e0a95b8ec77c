// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/centre_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/tolerances.h"

namespace hull::mesh {
namespace {

// Borders that leave the plane on purpose, as a deck's edge at the stem, do so more steeply.
constexpr double kAlong = 0.01;

template <class Visit>
void for_each_border_edge(const Topology& topology, const Visit& visit) {
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    if (topology.twin(h) < 0) visit(topology.origin(h), topology.origin(topology.next(h)));
  }
}

}  // namespace

std::vector<Eigen::Vector3d> points_with_centre_line(const ControlMesh& mesh) {
  const std::vector<Eigen::Vector3d>& points = mesh.points();
  const double on = kOnCentrePlane * mesh.size();
  std::vector<Eigen::Vector3d> result = points;
  for_each_border_edge(mesh.topology(), [&](int a, int b) {
    if (std::abs(points[a].y()) <= on && std::abs(points[b].y()) <= on) {
      result[a].y() = result[b].y() = 0.0;
    }
  });
  return result;
}

std::vector<int> vertices_near_centre_line(const ControlMesh& mesh) {
  std::vector<Eigen::Vector3d> points = mesh.points();
  const double on = kOnCentrePlane * mesh.size(), near = kNearCentrePlane * mesh.size();
  std::vector<int> found;
  std::size_t known = 0;
  // Some edges run along the plane only when one of their ends has been put there.
  do {
    known = found.size();
    for_each_border_edge(mesh.topology(), [&](int a, int b) {
      const double farther = std::max(std::abs(points[a].y()), std::abs(points[b].y()));
      if (farther > near || farther > kAlong * (points[b] - points[a]).norm()) return;
      for (int v : {a, b}) {
        if (std::abs(points[v].y()) <= on) continue;
        found.push_back(v);
        points[v].y() = 0.0;
      }
    });
  } while (found.size() > known);
  std::ranges::sort(found);
  return found;
}

}  // namespace hull::mesh

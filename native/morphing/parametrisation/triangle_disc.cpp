// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/triangle_disc.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace hull::morphing {
namespace {

mesh::MeshArrays arrays_of(std::vector<Vector3d> points, const std::vector<Triangle>& triangles) {
  mesh::MeshArrays arrays;
  arrays.points = std::move(points);
  arrays.face_sizes.assign(triangles.size(), 3);
  for (const Triangle& corners : triangles) {
    arrays.face_vertices.insert(arrays.face_vertices.end(), corners.begin(), corners.end());
  }
  return arrays;
}

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

void check_points_and_edges(const mesh::ControlMesh& mesh) {
  const mesh::Topology& t = mesh.topology();
  for (int point = 0; point < t.vertex_count(); ++point) {
    if (t.outgoing(point) >= 0) continue;
    refuse("Point " + std::to_string(point) + " belongs to no triangle: leave it out.");
  }
  for (int h = 0; h < t.half_edge_count(); ++h) {
    const int from = t.origin(h), to = t.origin(t.next(h));
    if (mesh.points()[from] != mesh.points()[to]) continue;
    refuse("Edge " + std::to_string(from) + "–" + std::to_string(to) +
           " has no length: make its two points one.");
  }
}

void check_one_part(const mesh::Topology& t) {
  std::vector<char> seen(t.face_count(), 0);
  std::vector<int> waiting{0};
  seen[0] = 1;
  while (!waiting.empty()) {
    const int h = t.first_half_edge(waiting.back());
    waiting.pop_back();
    for (int side = h; side < h + 3; ++side) {
      // Over edges alone: what meets in a point is not joined.
      if (t.twin(side) < 0 || seen[t.face(t.twin(side))]) continue;
      seen[t.face(t.twin(side))] = 1;
      waiting.push_back(t.face(t.twin(side)));
    }
  }
  for (int face = 0; face < t.face_count(); ++face) {
    if (seen[face]) continue;
    refuse("Triangle " + std::to_string(face) +
           " is not joined with triangle 0: take each part by itself.");
  }
}

std::vector<int> border_from(const mesh::Topology& t, int begin) {
  std::vector<int> border;
  int h = begin;
  do {
    border.push_back(h);
    // The outgoing half-edge of a border point is that along the border.
    h = t.outgoing(t.origin(t.next(h)));
  } while (h != begin);
  return border;
}

std::vector<int> only_border(const mesh::Topology& t) {
  std::vector<int> border;
  std::vector<char> is_on_it(t.vertex_count(), 0);
  for (int point = 0; point < t.vertex_count(); ++point) {
    // From each border point that no border has come by yet.
    if (t.twin(t.outgoing(point)) >= 0 || is_on_it[point]) continue;
    if (!border.empty()) {
      refuse("The triangles have more than one border: points " +
             std::to_string(t.origin(border.front())) + " and " + std::to_string(point) +
             " are on different ones. Close the hole, or cut the surface from one to the other.");
    }
    border = border_from(t, t.outgoing(point));
    for (int h : border) is_on_it[t.origin(h)] = 1;
  }
  if (border.empty()) refuse("The triangles have no border: cut the closed surface open.");
  return border;
}

}  // namespace

TriangleDisc::TriangleDisc(std::vector<Vector3d> points, const std::vector<Triangle>& triangles)
    : mesh_(arrays_of(std::move(points), triangles)) {
  const mesh::Topology& t = topology();
  check_points_and_edges(mesh_);
  check_one_part(t);
  border_ = only_border(t);
  // In one part, with one border: each handle takes 2 from the 1 of a disc.
  if (t.vertex_count() - t.edge_count() + t.face_count() != 1) {
    refuse("The triangles have one border, but a handle: cut the surface along the handle.");
  }
}

Triangle TriangleDisc::triangle(int t) const {
  const mesh::Topology& all = topology();
  return {all.origin(3 * t), all.origin(3 * t + 1), all.origin(3 * t + 2)};
}

std::vector<Triangle> TriangleDisc::triangles() const {
  std::vector<Triangle> all(triangle_count());
  for (int t = 0; t < triangle_count(); ++t) all[t] = triangle(t);
  return all;
}

}  // namespace hull::morphing

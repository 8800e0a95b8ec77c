// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/control_mesh.h"

namespace hull::morphing {

using Triangle = std::array<int, 3>;

// A surface of triangles that is a disc: manifold, turned to one side, in one part, with one border
// and no handle. Points are in m. Immutable; copies share the topology.
//
// Half-edges of triangle t are 3t, 3t + 1, 3t + 2, from its first, second and third corner.
class TriangleDisc {
 public:
  // Throws std::invalid_argument, naming a point, an edge or a triangle, for what is no disc, for
  // points that no triangle has, and for edges without length.
  TriangleDisc(std::vector<Vector3d> points, const std::vector<Triangle>& triangles);

  const std::vector<Vector3d>& points() const { return mesh_.points(); }
  const mesh::Topology& topology() const { return mesh_.topology(); }
  int triangle_count() const { return topology().face_count(); }
  Triangle triangle(int t) const;
  std::vector<Triangle> triangles() const;

  // Half-edges along the border, one after the other, with the surface to their left; from the one
  // that leaves the border point of least index.
  const std::vector<int>& border() const { return border_; }
  bool is_border_point(int point) const { return topology().twin(topology().outgoing(point)) < 0; }

 private:
  mesh::ControlMesh mesh_;
  std::vector<int> border_;
};

}  // namespace hull::morphing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/refined_mesh.h"

#include <utility>

namespace hull::surface {

mesh::ControlMesh refined_mesh(const LimitSurface& surface) {
  const mesh::Topology& coarse = surface.mesh().topology();
  const mesh::Topology& fine = surface.cells();
  mesh::MeshArrays arrays;
  arrays.points = surface.layout().refine(coarse, surface.mesh().points());
  arrays.points.resize(fine.vertex_count());
  for (int v = 0; v < coarse.vertex_count(); ++v) {
    if (coarse.outgoing(v) < 0) arrays.points[v] = surface.mesh().points()[v];
  }
  arrays.face_sizes.assign(fine.face_count(), 4);
  arrays.face_vertices.reserve(fine.half_edge_count());
  for (int h = 0; h < fine.half_edge_count(); ++h) {
    arrays.face_vertices.push_back(fine.origin(h));
    if (fine.is_crease(h) && fine.is_edge_front(h)) {
      arrays.creases.push_back({fine.origin(h), fine.origin(fine.next(h))});
    }
  }
  // All corners are named: which of the border's are rounded is not kept by the coarse mesh.
  arrays.round_border_corners = true;
  for (int v = 0; v < fine.vertex_count(); ++v) {
    const mesh::VertexKind kind = fine.kind(v);
    if (kind == mesh::VertexKind::kCorner || kind == mesh::VertexKind::kCone) {
      arrays.corners.push_back(v);
    }
  }
  return mesh::ControlMesh(std::move(arrays));
}

}  // namespace hull::surface

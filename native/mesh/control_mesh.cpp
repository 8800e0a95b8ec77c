// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/control_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "mesh/tolerances.h"

namespace hull::mesh {
namespace {

Eigen::AlignedBox3d box_of_faces(const Topology& topology,
                                 const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (int h = 0; h < topology.half_edge_count(); ++h) box.extend(points[topology.origin(h)]);
  return box;
}

}  // namespace

ControlMesh::ControlMesh(MeshArrays arrays) {
  std::vector<MeshProblem> problems = check_mesh(arrays);
  if (!problems.empty() && problems.front().severity == Severity::kError) {
    throw std::invalid_argument(problems.front().message);
  }
  // Errors come first: without one in front all problems are warnings. Points may move: which faces
  // have no area is found when it is asked for.
  std::erase_if(problems, [](const MeshProblem& p) { return p.kind == ElementKind::kFace; });
  tags_ = std::make_shared<const Tags>(
      Tags{Topology(static_cast<int>(arrays.points.size()), arrays.face_sizes, arrays.face_vertices,
                    arrays.creases, arrays.corners, arrays.round_border_corners),
           std::move(problems)});
  const Eigen::AlignedBox3d box = box_of_faces(topology(), arrays.points);
  set_points(std::move(arrays.points), box);
}

ControlMesh ControlMesh::with_points(std::vector<Eigen::Vector3d> points) const {
  if (points.size() != points_.size()) {
    throw std::invalid_argument("The mesh has " + std::to_string(points_.size()) + " points, but " +
                                std::to_string(points.size()) + " positions were given.");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Of all that check_mesh() refuses these and the size alone depend on where points are.
    if (!points[i].allFinite() || points[i].cwiseAbs().maxCoeff() > kMaxCoordinate) {
      throw std::invalid_argument("The position given for point " + std::to_string(i) +
                                  " is not finite or too far away.");
    }
  }
  const Eigen::AlignedBox3d box = box_of_faces(topology(), points);
  if (box.sizes().maxCoeff() < kLeastSize) {
    throw std::invalid_argument(
        "The points given all lie in one place: the mesh would have no size.");
  }
  ControlMesh moved = *this;
  moved.set_points(std::move(points), box);
  return moved;
}

void ControlMesh::set_points(std::vector<Eigen::Vector3d> points, const Eigen::AlignedBox3d& box) {
  points_ = std::move(points);
  box_ = box;
  size_ = box.diagonal().norm();
}

std::vector<MeshProblem> ControlMesh::warnings() const {
  const Topology& t = topology();
  std::vector<int> sizes, vertices;
  for (int f = 0; f < t.face_count(); ++f) sizes.push_back(t.face_size(f));
  for (int h = 0; h < t.half_edge_count(); ++h) vertices.push_back(t.origin(h));
  std::vector<MeshProblem> warnings = tags_->warnings;
  if (const auto flat = faces_without_area(points_, sizes, vertices)) {
    // Where check_mesh() has it: before those of edges.
    const auto edges = std::find_if(warnings.begin(), warnings.end(), [](const MeshProblem& p) {
      return p.kind == ElementKind::kEdge;
    });
    warnings.insert(edges, *flat);
  }
  return warnings;
}

std::vector<int> ControlMesh::irregular_vertices() const {
  const Topology& t = topology();
  std::vector<int> vertices;
  std::vector<char> irregular(t.vertex_count(), 0);
  for (int h = 0; h < t.half_edge_count(); ++h) {
    // Sector by sector: a vertex is regular only if all of its sectors are.
    const int faces = t.sector_faces(h);
    switch (t.kind_at(h)) {
      case VertexKind::kSmooth:
        irregular[t.origin(h)] |= faces != 4;
        break;
      case VertexKind::kCrease:
        irregular[t.origin(h)] |= faces != 2;
        break;
      case VertexKind::kCorner:
        irregular[t.origin(h)] |= faces != 1;
        break;
      default:
        irregular[t.origin(h)] = 1;
    }
  }
  for (int v = 0; v < t.vertex_count(); ++v) {
    if (irregular[v]) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace hull::mesh

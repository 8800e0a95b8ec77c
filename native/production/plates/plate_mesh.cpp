// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/plate_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hull::production {

using Eigen::Vector2d;

double height_of(const PlateMesh& mesh, const PlateMesh::Element& element) {
  const auto& numbers = mesh.triangle(element).points;
  const auto& points = mesh.shell->mesh.points;
  const Vector3d a = points[numbers[0]], b = points[numbers[1]], c = points[numbers[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return (b - a).cross(c - a).norm() / longest;
}

double thin_height(const PlateMesh& mesh, double area) {
  return 0.25 * std::sqrt(2.0 * area / static_cast<double>(mesh.elements.size()));
}

PlateMesh plate_mesh(const Plating& plating, const Plate& plate) {
  PlateMesh mesh;
  mesh.shell = plating.shell;
  for (const int t : plate.triangles) {
    PlateMesh::Element& element = mesh.elements.emplace_back();
    element.triangle = t;
    const auto& points = mesh.shell->mesh.triangles[t].points;
    for (int k = 0; k < 3; ++k) {
      const auto [found, is_new] =
          mesh.node_of_point.try_emplace(points[k], static_cast<int>(mesh.corners.size()));
      if (is_new) mesh.corners.push_back(points[k]);
      element.nodes[k] = found->second;
    }
  }
  mesh.node_count = static_cast<int>(mesh.corners.size());
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    PlateMesh::Element& element = mesh.elements[i];
    const ShellTriangle& triangle = mesh.triangle(element);
    for (int k = 0; k < 3; ++k) {
      const auto key = ShellMesh::pair_key(triangle.points[k], triangle.points[(k + 1) % 3]);
      const auto [found, is_new] = mesh.middle_of_side.try_emplace(key, mesh.node_count);
      if (is_new) ++mesh.node_count;
      element.nodes[3 + k] = found->second;
    }
    mesh.in_cell[triangle.cell].push_back(static_cast<int>(i));
  }
  // Euler's formula: a disc has corners - sides + triangles = 1.
  const auto sides = static_cast<long>(mesh.middle_of_side.size());
  if (static_cast<long>(mesh.corners.size()) - sides + static_cast<long>(mesh.elements.size()) !=
          1 ||
      plate.loops.size() != 1) {
    throw std::invalid_argument(
        "A plate that has a hole, or is closed around the hull, can't be laid out: divide it by "
        "seams.");
  }
  return mesh;
}

Eigen::Vector3d barycentric(const ShellTriangle& t, const Vector2d& uv) {
  Eigen::Matrix2d m;
  m << t.uv[0] - t.uv[2], t.uv[1] - t.uv[2];
  const Vector2d b = m.inverse() * (uv - t.uv[2]);
  return {b.x(), b.y(), 1.0 - b.x() - b.y()};
}

ElementValues element_values(const Eigen::Vector3d& b) {
  return {b[0] * (2.0 * b[0] - 1.0), b[1] * (2.0 * b[1] - 1.0), b[2] * (2.0 * b[2] - 1.0),
          4.0 * b[0] * b[1],         4.0 * b[1] * b[2],         4.0 * b[2] * b[0]};
}

Eigen::Matrix<double, 6, 2> element_slopes(const Eigen::Vector3d& b) {
  Eigen::Matrix<double, 6, 2> s;
  s << 4.0 * b[0] - 1.0, 0.0,              //
      0.0, 4.0 * b[1] - 1.0,               //
      1.0 - 4.0 * b[2], 1.0 - 4.0 * b[2],  //
      4.0 * b[1], 4.0 * b[0],              //
      -4.0 * b[1], 4.0 * (b[2] - b[1]),    //
      4.0 * (b[2] - b[0]), -4.0 * b[0];
  return s;
}

std::optional<ElementPoint> element_point(const surface::LimitSurface& surface,
                                          const ShellTriangle& t, const Eigen::Vector3d& b,
                                          bool bending) {
  const Vector2d uv = b[0] * t.uv[0] + b[1] * t.uv[1] + b[2] * t.uv[2];
  const auto jet = surface.evaluate(t.cell, std::clamp(uv.x(), 0.0, 1.0),
                                    std::clamp(uv.y(), 0.0, 1.0), bending ? 2 : 1);
  const Vector3d normal = jet.du.cross(jet.dv);
  if (!(normal.norm() > 1e-12 * (jet.du.squaredNorm() + jet.dv.squaredNorm()))) {
    return std::nullopt;
  }
  // Columns: along the first two barycentric coordinates, in (u, v).
  Eigen::Matrix2d along;
  along << t.uv[0] - t.uv[2], t.uv[1] - t.uv[2];
  const Vector3d e1 = jet.du.normalized(), e2 = normal.normalized().cross(e1);
  Eigen::Matrix2d lengths;  // of (u, v), in the tangents
  lengths << jet.du.dot(e1), jet.dv.dot(e1), jet.du.dot(e2), jet.dv.dot(e2);
  const Eigen::Matrix2d per_coordinate = lengths * along;
  ElementPoint point;
  point.slopes = element_slopes(b) * per_coordinate.inverse();
  point.area = std::abs(per_coordinate.determinant());
  if (bending) {
    const Vector3d n = normal.normalized();
    Eigen::Matrix2d second;
    second << -jet.duu.dot(n), -jet.duv.dot(n), -jet.duv.dot(n), -jet.dvv.dot(n);
    const Eigen::Matrix2d to_uv = lengths.inverse();
    point.bending = to_uv.transpose() * second * to_uv;
  }
  return point;
}

}  // namespace hull::production

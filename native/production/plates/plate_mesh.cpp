// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/plate_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

namespace hull::production {

namespace {

// Six points, exact for polynomials of degree 4 (Dunavant 1985); weights sum to ½.
struct PlateRule {
  std::array<Eigen::Vector3d, 6> at;
  std::array<double, 6> weights;
  PlateRule() {
    const double a = 0.445948490915965, b = 0.091576213509771;
    const double wa = 0.5 * 0.223381589678011, wb = 0.5 * 0.109951743655322;
    for (int k = 0; k < 3; ++k) {
      at[k] = Eigen::Vector3d::Constant(a);
      // Three points near the middles of sides, then three near corners.
      at[k][k] = 1.0 - 2.0 * a;
      at[3 + k] = Eigen::Vector3d::Constant(b);
      at[3 + k][k] = 1.0 - 2.0 * b;
      weights[k] = wa;
      weights[3 + k] = wb;
    }
  }
};

constexpr int kMostTriangleParts = 8;

double longest_side(const PlateMesh& mesh, const PlateMesh::Element& element) {
  const auto& numbers = mesh.triangle(element).points;
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Vector3d& a = mesh.shell->mesh.points[numbers[k]];
    longest = std::max(longest, (mesh.shell->mesh.points[numbers[(k + 1) % 3]] - a).norm());
  }
  return longest;
}

// The barycentric coordinates of the k² equal parts of a triangle, their corners in columns.
std::vector<Eigen::Matrix3d> parts_of_triangle(int k) {
  std::vector<Eigen::Matrix3d> parts;
  const auto at = [k](int i, int j) -> Eigen::Vector3d {
    return Eigen::Vector3d(k - i - j, i, j) / static_cast<double>(k);
  };
  for (int i = 0; i < k; ++i) {
    for (int j = 0; i + j < k; ++j) {
      // One that stands, and one on its head beside it, but at the row's end.
      Eigen::Matrix3d part;
      part << at(i, j), at(i + 1, j), at(i, j + 1);
      parts.push_back(part);
      if (i + j + 1 == k) continue;
      part << at(i + 1, j), at(i + 1, j + 1), at(i, j + 1);
      parts.push_back(part);
    }
  }
  return parts;
}

// The turning of a loop on the surface, rad: -2π around a hole in a plane, none around a cylinder.
double turning(const PlateMesh& mesh, const std::vector<PlateSide>& loop) {
  std::vector<int> line;
  for (const PlateSide& side : loop)
    line.insert(line.end(), side.points.begin(), side.points.end() - 1);
  std::unordered_map<int, Vector3d> normals;
  for (const int point : line) normals.try_emplace(point, Vector3d::Zero());
  for (const PlateMesh::Element& element : mesh.elements) {
    const ShellTriangle& t = mesh.triangle(element);
    for (int k = 0; k < 3; ++k) {
      const auto found = normals.find(t.points[k]);
      if (found == normals.end()) continue;
      // Of several sectors' normals at a point any will do: only the sense of turning is asked.
      found->second = mesh.shell->surface.normal(t.cell, t.uv[k].x(), t.uv[k].y());
    }
  }
  const auto& points = mesh.shell->mesh.points;
  const std::size_t n = line.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d& at = points[line[i]];
    const Vector3d before = at - points[line[(i + n - 1) % n]],
                   after = points[line[(i + 1) % n]] - at;
    sum += std::atan2(normals.at(line[i]).dot(before.cross(after)), before.dot(after));
  }
  return sum;
}

// Euler's formula: a disc with holes has corners - sides + triangles = 2 - loops.
void require_disc_with_holes(const PlateMesh& mesh, const Plate& plate) {
  const auto sides = static_cast<long>(mesh.middle_of_side.size());
  const auto loops = static_cast<long>(plate.loops.size());
  const long found =
      static_cast<long>(mesh.corners.size()) - sides + static_cast<long>(mesh.elements.size());
  bool is_one = loops > 0 && found == 2 - loops;
  for (long k = 1; is_one && k < loops; ++k) is_one = turning(mesh, plate.loops[k]) < -M_PI;
  if (is_one) return;
  throw std::invalid_argument(
      "A plate that is closed around the hull can't be laid out: divide it by seams or butts.");
}

}  // namespace

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
  // Middles are numbered after all corners: so a side's number is its middle's less their count.
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
  require_disc_with_holes(mesh, plate);
  return mesh;
}

Eigen::Vector3d barycentric(const ShellTriangle& t, const Vector2d& uv) {
  Eigen::Matrix2d m;
  m << t.uv[0] - t.uv[2], t.uv[1] - t.uv[2];
  const Vector2d b = m.inverse() * (uv - t.uv[2]);
  return {b.x(), b.y(), 1.0 - b.x() - b.y()};
}

std::optional<PlatePoint> plate_point(const surface::LimitSurface& surface, const ShellTriangle& t,
                                      const Eigen::Vector3d& b, bool bending) {
  const Vector2d uv = b[0] * t.uv[0] + b[1] * t.uv[1] + b[2] * t.uv[2];
  // The sum may be off the cell by rounding.
  const auto jet = surface.evaluate(t.cell, std::clamp(uv.x(), 0.0, 1.0),
                                    std::clamp(uv.y(), 0.0, 1.0), bending ? 2 : 1);
  const Vector3d normal = jet.du.cross(jet.dv);
  // Beside the lengths of both: where they are parallel, or one is gone, there is no tangent plane.
  if (!(normal.norm() > 1e-12 * (jet.du.squaredNorm() + jet.dv.squaredNorm()))) {
    return std::nullopt;
  }
  Eigen::Matrix2d along;  // columns: along the first two barycentric coordinates, in (u, v)
  along << t.uv[0] - t.uv[2], t.uv[1] - t.uv[2];
  const Vector3d n = normal.normalized(), e1 = jet.du.normalized(), e2 = n.cross(e1);
  PlatePoint point;
  point.at = jet.point;
  point.tangents << e1, e2;
  point.area = std::abs(along.determinant()) * normal.norm();
  point.bending.setZero();
  if (!bending) return point;
  Eigen::Matrix2d lengths, second;  // of (u, v), in the tangents
  lengths << jet.du.dot(e1), jet.dv.dot(e1), jet.du.dot(e2), jet.dv.dot(e2);
  // The normal points into the water, from which a surface that bulges bends away.
  second << -jet.duu.dot(n), -jet.duv.dot(n), -jet.duv.dot(n), -jet.dvv.dot(n);
  const Eigen::Matrix2d to_uv = lengths.inverse();
  // Pulled back from (u, v) to the two unit tangents.
  point.bending = to_uv.transpose() * second * to_uv;
  return point;
}

std::vector<PlatePoint> quadrature_points(const PlateMesh& mesh, double size, bool is_mirrored) {
  static const PlateRule rule;
  std::vector<PlatePoint> points;
  for (const PlateMesh::Element& element : mesh.elements) {
    const auto parts = static_cast<int>(
        std::clamp(std::ceil(longest_side(mesh, element) / size), 1.0, 1.0 * kMostTriangleParts));
    for (const Eigen::Matrix3d& part : parts_of_triangle(parts)) {
      for (std::size_t k = 0; k < rule.at.size(); ++k) {
        const auto point =
            plate_point(mesh.shell->surface, mesh.triangle(element), part * rule.at[k]);
        if (!point) continue;
        points.push_back(*point);
        points.back().area *= rule.weights[k] / (parts * parts);
      }
    }
  }
  if (!is_mirrored) return points;
  const std::size_t own = points.size();
  for (std::size_t i = 0; i < own; ++i) {
    PlatePoint other = points[i];
    other.at.y() *= -1.0;
    other.tangents.row(1) *= -1.0;
    other.tangents.col(1) *= -1.0;  // seen from the water again
    points.push_back(other);
  }
  return points;
}

}  // namespace hull::production

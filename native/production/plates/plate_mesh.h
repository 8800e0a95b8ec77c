// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <unordered_map>

#include "production/plates/shell_plates.h"

namespace hull::production {

// A plate's triangles with their nodes: corners, then the middles of sides.
struct PlateMesh {
  struct Element {
    int triangle;              // of the shell's mesh
    std::array<int, 6> nodes;  // corners 0, 1, 2; middles of 01, 12, 20
  };
  std::shared_ptr<const PlatedShell> shell;
  std::vector<Element> elements;
  std::vector<int> corners;  // the shell's points that nodes 0 … corners.size() - 1 are
  int node_count = 0;
  std::unordered_map<int, int> node_of_point;
  std::unordered_map<std::uint64_t, int> middle_of_side;  // by ShellMesh::pair_key()
  std::unordered_map<int, std::vector<int>> in_cell;      // elements

  const ShellTriangle& triangle(const Element& element) const {
    return shell->mesh.triangles[element.triangle];
  }
};

PlateMesh plate_mesh(const Plating& plating, const Plate& plate);

// In barycentric coordinates of (u, v) in a triangle; they sum to one.
Eigen::Vector3d barycentric(const ShellTriangle& triangle, const Eigen::Vector2d& uv);

// A place of a plate, with two orthogonal unit tangents there, counter-clockwise seen from the
// water.
struct PlatePoint {
  Vector3d at;
  Eigen::Matrix<double, 3, 2> tangents;
  double area;  // per area of barycentric coordinates (b0, b1), or what the point stands for, m²
  // Second fundamental form in these tangents, 1/m; positive where it bulges into the water.
  Eigen::Matrix2d bending;
};

// In barycentric coordinates of a triangle; `bending` only if asked for. None where the surface has
// no tangent plane by its derivatives.
std::optional<PlatePoint> plate_point(const surface::LimitSurface& surface,
                                      const ShellTriangle& triangle, const Eigen::Vector3d& b,
                                      bool bending = false);

// Points for integrals over the plate, six a triangle (Dunavant 1985), of parts of triangles with
// sides no longer than `size`. `is_mirrored`: and those of the plate's mirror image about y = 0.
std::vector<PlatePoint> quadrature_points(const PlateMesh& mesh, double size, bool is_mirrored);

}  // namespace hull::production

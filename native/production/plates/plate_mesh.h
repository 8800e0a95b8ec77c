// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <unordered_map>

#include "production/plates/shell_plates.h"

namespace hull::production {

// A plate's triangles with the nodes of quadratic elements: corners, then the middles of sides.
struct PlateMesh {
  struct Element {
    int triangle;              // of the shell's mesh
    std::array<int, 6> nodes;  // corners 0, 1, 2; middles of 01, 12, 20
  };
  std::shared_ptr<const Shell> shell;
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

// Of an element's corners, the height over their longest side, m.
double height_of(const PlateMesh& mesh, const PlateMesh::Element& element);
// The height, m, below which an element is thin, a quarter of what the elements of the plate's area
// have in the mean: curves that pass close to one another, or to corners of cells, leave such.
// Their strain is rounding for the most part.
double thin_height(const PlateMesh& mesh, double area);

PlateMesh plate_mesh(const Plating& plating, const Plate& plate);

// In barycentric coordinates of (u, v) in a triangle; they sum to one.
Eigen::Vector3d barycentric(const ShellTriangle& triangle, const Eigen::Vector2d& uv);

// The six functions of a quadratic element, and their derivatives by the first two barycentric
// coordinates, the third one being what is left of one.
using ElementValues = std::array<double, 6>;
ElementValues element_values(const Eigen::Vector3d& b);
Eigen::Matrix<double, 6, 2> element_slopes(const Eigen::Vector3d& b);

// The derivatives of the element's functions by lengths along two orthogonal unit tangents of the
// surface, and the area per area of barycentric coordinates (b0, b1). None where the surface has no
// tangent plane by its derivatives.
struct ElementPoint {
  Eigen::Matrix<double, 6, 2> slopes;  // 1/m
  double area;                         // m²
  // Second fundamental form in these tangents, 1/m; positive where it bulges into the water.
  Eigen::Matrix2d bending;
};
std::optional<ElementPoint> element_point(const surface::LimitSurface& surface,
                                          const ShellTriangle& triangle, const Eigen::Vector3d& b,
                                          bool bending = false);

}  // namespace hull::production

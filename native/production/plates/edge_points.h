// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "production/plates/cell_triangulation.h"
#include "production/plates/shell_mesh.h"
#include "surface/place_in_cell.h"

namespace hull::production {

// A place on an edge of cells, in parts of CellTriangulation::kParts from the origin of the edge's
// front half-edge; edge -1 is none.
struct EdgePlace {
  int edge = -1;
  std::int64_t at = 0;
};

CellTriangulation::Grid on_grid(const Eigen::Vector2d& uv);

// (0 … kParts) along half-edge h to a place in its cell.
inline Eigen::Vector2d on_half_edge(int h, std::int64_t along) {
  constexpr auto kParts = static_cast<double>(CellTriangulation::kParts);
  return surface::on_square_side(h % 4, static_cast<double>(along) / kParts);
}

// The points of a shell's mesh on the sides of cells, which cells share.
class EdgePoints {
 public:
  // Gives `mesh` the corners of cells as its first points. REQUIRES: both outlive this.
  EdgePoints(const surface::LimitSurface& surface, ShellMesh& mesh);

  int front(int edge) const { return front_[edge]; }
  double length(int edge) const { return shapes_[edge].length; }  // about, m
  double turn(int edge) const { return shapes_[edge].turn; }      // from end to end, about, rad

  // Where on the side of a cell a place of the grid is; corners count to the side asked for.
  EdgePlace on_side(int cell, int side, const CellTriangulation::Grid& at) const;

  // The mesh's point there; a new one where none is.
  int point(const EdgePlace& place);

  // An end of a curve's step on a side of its cell goes to the point that is there, within
  // rounding.
  Eigen::Vector2d put_on_sides(int cell, Eigen::Vector2d uv);

  // Adds points that divide an edge in so many parts, where others are not nearer than `clear` of a
  // part.
  void divide(int edge, int parts, double clear);

  // From the front half-edge's origin on: place, point, next place, next point.
  struct Part {
    std::int64_t from;
    int first;
    std::int64_t to;
    int last;
  };
  std::vector<Part> parts(int edge);

  // Between the ends.
  const std::map<std::int64_t, int>& on_edge(int edge) const { return on_edge_[edge]; }

 private:
  EdgePlace merged(EdgePlace place) const;

  const surface::LimitSurface& surface_;
  const mesh::Topology& cells_;
  ShellMesh& mesh_;
  std::vector<std::map<std::int64_t, int>> on_edge_;
  std::vector<int> front_;
  struct Shape {
    double length, turn;
  };
  static Shape shape_of(const surface::LimitSurface& surface, int half_edge);
  std::vector<Shape> shapes_;
};

}  // namespace hull::production

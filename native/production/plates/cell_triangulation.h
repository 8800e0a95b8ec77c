// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace hull::production {

// The unit square cut into triangles with given points and edges: a constrained Delaunay
// triangulation (Sloan 1993). What lies where is decided with whole numbers, parts of 2^29 of the
// square's side, so that nothing depends on rounding; points at the same numbers are one.
class CellTriangulation {
 public:
  using Grid = std::array<std::int64_t, 2>;
  static constexpr std::int64_t kParts = std::int64_t{1} << 29;

  struct Edge {
    int a, b;
    int tag;
  };

  // `lengths` of the sides along u and v: triangles are well shaped when the square is so
  // stretched. Points 0 to 3 are the corners (0, 0), (1, 0), (1, 1), (0, 1).
  explicit CellTriangulation(const Eigen::Vector2d& lengths);

  // The number of the point; of the one that is there already, if there is. REQUIRES: within the
  // square.
  int add(const Grid& at);

  // Makes an edge, or edges through points on the way, tagged with a number >= 0. Where edges that
  // were made before are crossed it goes by their nearer end.
  void constrain(int a, int b, int tag);

  // Once all edges are made: counter-clockwise corners.
  std::vector<std::array<int, 3>> triangles();
  std::vector<Edge> constraints() const;

 private:
  struct Triangle {
    std::array<int, 3> v;
    std::array<int, 3> beyond;  // across the edge from v[i] to v[i + 1]; -1 at the border
    std::array<int, 3> tag;     // of that edge; -1 for none
  };
  struct Side {
    int triangle, edge;
  };

  std::int64_t turn(int a, int b, int c) const;
  bool is_crossed(int a, int b, int c, int d) const;
  bool wants_flip(const Side& side) const;
  bool can_flip(const Side& side) const;
  Side twin(const Side& side) const;
  Side find(int a, int b) const;
  void flip(const Side& side);
  void link(int triangle, int edge, int beyond, int from);
  void split_triangle(int triangle, int p);
  void split_side(const Side& side, int p);
  void legalise(std::vector<Side> sides);
  void mark(const Side& side, int tag);
  int next_on_way(int a, int b, std::vector<std::array<int, 2>>& crossed, int& detour) const;
  void clear_way(int a, int b, std::vector<std::array<int, 2>> crossed);

  Eigen::Vector2d lengths_;
  std::vector<Grid> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace hull::production

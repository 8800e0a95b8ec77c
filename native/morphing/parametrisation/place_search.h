// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "morphing/parametrisation/disc_map.h"

namespace hull::morphing {

// A point of a disc: in a triangle, at the mean of its corners by weights that are not negative and
// add up to 1.
struct DiscPlace {
  int triangle;
  std::array<double, 3> weights;
};

// The point in space, m; and in the plane.
Vector3d position_at(const DiscMap& map, const DiscPlace& at);
Vector2d place_at(const DiscMap& map, const DiscPlace& at);

// Which point of a disc is laid at a place of the plane: the inverse of the map, which it refers
// to.
class PlaceSearch {
 public:
  explicit PlaceSearch(const DiscMap& map);

  const DiscMap& map() const { return map_; }

  // The triangle that has the place within it or on its edges, by exact predicates; of several, at
  // an edge or corner, that of least number. A place beyond the border by less than 1e-12 of the
  // polygon's size is there by rounding, and taken for the nearest one of the border. Throws
  // std::invalid_argument for others.
  DiscPlace find(const Vector2d& place) const;

 private:
  struct Node {
    Eigen::AlignedBox2d box;
    int left, right;  // nodes; or, of a leaf, -1 and the triangle
  };
  int build(int* begin, int* end, const std::vector<Eigen::AlignedBox2d>& boxes);
  DiscPlace on_border(const Vector2d& place) const;

  const DiscMap& map_;
  std::vector<Node> nodes_;
};

}  // namespace hull::morphing

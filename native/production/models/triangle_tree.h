// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "mesh/vectors.h"
#include "production/models/closed_model.h"

namespace hull::production {

// The nearest points of a model's triangles, exact but for rounding (Ericson 2005).
class TriangleTree {
 public:
  explicit TriangleTree(const ClosedModel& model);

  struct Nearest {
    Vector3d point;
    double distance;
    int triangle;
    bool within;  // the triangle's inner, not its border
  };

  // `no_further`: a distance within which there is a point.
  Nearest nearest(const Vector3d& p, double no_further) const;

  // Whether a point is inside, by the angles under which it sees the triangles.
  bool encloses(const Vector3d& p) const;

  const Eigen::AlignedBox3d& box() const { return nodes_[0].box; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int left = -1, right = -1;  // none: a leaf
    int begin = 0, end = 0;     // of order_
  };

  int build(int begin, int end, const std::vector<Vector3d>& centres);

  const ClosedModel& model_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace hull::production

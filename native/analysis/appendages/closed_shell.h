// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <vector>

#include "analysis/appendages/arc_crossings.h"

namespace hull::analysis {

// How many parts of lines may be looked at still, by all threads together.
using PartsLeft = std::atomic<int>;

// A body by bicubic patches that enclose it, S_u x S_v outwards, in a hierarchy of boxes: what is
// inside, and where arcs pass through its surface. Immutable; queries are thread-safe.
class ClosedShell {
 public:
  // `least_width`: m, what of the body is not missed by lines that far apart, as a radius or
  // half a thickness. REQUIRES: at least one patch.
  ClosedShell(std::vector<surface::BezierPatch> patches, double least_width);

  const std::vector<surface::BezierPatch>& patches() const { return patches_; }
  const Eigen::AlignedBox3d& box() const { return boxes_.front(); }
  double least_width() const { return least_width_; }

  // Whether any patch's box meets the box.
  bool comes_near(const Eigen::AlignedBox3d& box) const;
  // Appends the arc's crossings with the surface, unsorted; those at common sides may be there more
  // than once. Returns how many parts were looked at.
  int find_crossings(const CubicArc& arc, std::vector<ArcCrossing>& crossings) const;
  // By how often a line to the outside passes the surface outwards: of a point on the surface
  // either answer. The parts that were looked at are taken off *parts_left, if any.
  bool is_inside(const Vector3d& point, PartsLeft* parts_left = nullptr) const;

 private:
  // A range of patches; leaves have no nodes below.
  struct Node {
    int begin, end, left = -1, right = -1;
  };
  int build(int begin, int end, const std::vector<Eigen::AlignedBox3d>& boxes);
  template <class Meets, class Visit>
  void visit(const Meets& meets, const Visit& act) const;

  std::vector<surface::BezierPatch> patches_;
  double least_width_, touching_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
  std::vector<Eigen::AlignedBox3d> boxes_;  // of nodes
};

}  // namespace hull::analysis

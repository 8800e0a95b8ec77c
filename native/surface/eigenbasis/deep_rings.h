// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "surface/queries/surface_tree.h"

namespace hull::surface {

// Walks from a deep corner of a tree towards its knot, ring by ring. Costs some microseconds a
// ring, and nothing of it is kept: queries get there seldom, a deep corner being 1/256 of a cell.
class DeepRings {
 public:
  // Beyond this many rings, or once a square is smaller than kSmallest of the size, its knot stands
  // for all of it.
  static constexpr int kMostRings = 200;
  static constexpr double kSmallest = 1e-15;

  // `tree` must outlive the walk.
  DeepRings(const SurfaceTree& tree, int index)
      : index_(index),
        deep_(tree.deep_corner(index)),
        basis_(tree.layout().basis(deep_.corner)),
        ring_(basis_, deep_.points),
        smallest_(kSmallest * tree.error_size()) {
    for (int k = 0; k < kPlainRings; ++k) ring_.advance();
    square_ = ring_.points();
  }

  // Control points of what is left around the knot: it lies in their convex hull.
  const std::vector<Vector3d>& square() const { return square_; }
  const Vector3d& knot() const { return ring_.limit(); }
  int index() const { return index_; }
  const PiecePlace& place() const { return deep_.place; }

  bool is_down_to_knot() const {
    if (level_ >= kMostRings) return true;
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : square_) box.extend(p);
    return box.diagonal().norm() <= smallest_;
  }

  // Calls visit(const BezierPatch&, const PiecePlace&) for the pieces of the outermost ring of the
  // square, which is then halved.
  template <class Visit>
  void next_ring(const Visit& visit) {
    for (int s = 0; s < basis_.segment_count(); ++s) {
      const RingSegment& segment = basis_.segments()[s];
      PiecePlace place = deep_.place;
      place.seen = {std::ldexp(segment.u, -level_), std::ldexp(segment.v, -level_),
                    std::ldexp(segment.size, -level_)};
      visit(BezierPatch::from_bspline(ring_.segment_points(s)), place);
    }
    ring_.advance();
    ++level_;
    square_ = ring_.points();
  }

 private:
  int index_;
  const DeepCorner& deep_;
  const CornerBasis& basis_;
  CornerRing ring_;
  double smallest_;
  int level_ = kPlainRings;
  std::vector<Vector3d> square_;
};

}  // namespace hull::surface

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces.h"

#include <Eigen/Geometry>

namespace hull {
namespace {

constexpr int kDeepestRing = 60;

struct Square {
  double u, v, size;
};

// A square given as seen from corner `turn` of the unit square, in the unit square's own (u, v).
Square turned_square(int turn, const Square& s) {
  switch (turn) {
    case 0:
      return s;
    case 1:
      return {1.0 - s.v - s.size, s.u, s.size};
    case 2:
      return {1.0 - s.u - s.size, 1.0 - s.v - s.size, s.size};
    default:
      return {s.v, 1.0 - s.u - s.size, s.size};
  }
}

// The same for the grid of control points.
BicubicPoints turned_points(int turn, const BicubicPoints& seen) {
  if (turn == 0) return seen;
  BicubicPoints points;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) {
      const int i = turn == 1 ? b : turn == 2 ? 3 - a : 3 - b;
      const int j = turn == 1 ? 3 - a : turn == 2 ? 3 - b : a;
      points[4 * b + a] = seen[4 * j + i];
    }
  }
  return points;
}

Square within(const Square& outer, const Square& inner) {
  return {outer.u + outer.size * inner.u, outer.v + outer.size * inner.v, outer.size * inner.size};
}

class PieceVisitor {
 public:
  PieceVisitor(const LimitSurface& surface, int cell,
               const std::function<bool(const CornerSquare&)>& descend,
               const std::function<void(const SurfacePiece&)>& visit)
      : surface_(surface), cell_(cell), descend_(descend), visit_(visit) {}

  void visit_node(const SurfaceNode& node, const Square& square) const {
    switch (node.kind) {
      case SurfaceNode::Kind::kLeaf:
        visit_({cell_, square.u, square.v, square.size, surface_.leaf(node.index)});
        break;
      case SurfaceNode::Kind::kCorner:
        visit_rings(node, square);
        break;
      case SurfaceNode::Kind::kSplit: {
        const auto& children = surface_.layout().split(node.index);
        for (int i = 0; i < 4; ++i) {
          visit_node(children[i], within(square, {0.5 * (i & 1), 0.5 * (i >> 1), 0.5}));
        }
        break;
      }
    }
  }

 private:
  void visit_rings(const SurfaceNode& node, const Square& square) const {
    const CornerBasis& basis = surface_.layout().basis(node.index);
    CornerRing ring(basis, surface_.corner(node.index));
    double size = 1.0;
    for (int level = 1; level <= kDeepestRing; ++level, size *= 0.5, ring.advance()) {
      const Square rest = within(square, turned_square(node.turn, {0.0, 0.0, size}));
      if (!descend_({cell_, rest.u, rest.v, rest.size, ring.points()})) return;
      for (int s = 0; s < static_cast<int>(basis.segments().size()); ++s) {
        const RingSegment& segment = basis.segments()[s];
        const Square seen{segment.u * size, segment.v * size, segment.size * size};
        const Square place = within(square, turned_square(node.turn, seen));
        visit_({cell_, place.u, place.v, place.size,
                turned_points(node.turn, ring.segment_points(s))});
      }
    }
  }

  const LimitSurface& surface_;
  int cell_;
  const std::function<bool(const CornerSquare&)>& descend_;
  const std::function<void(const SurfacePiece&)>& visit_;
};

}  // namespace

double extent_of(const CornerSquare& square) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : square.points) box.extend(p);
  return box.diagonal().norm();
}

void for_each_piece(const LimitSurface& surface, int cell,
                    const std::function<bool(const CornerSquare&)>& descend,
                    const std::function<void(const SurfacePiece&)>& visit) {
  PieceVisitor(surface, cell, descend, visit)
      .visit_node(surface.layout().root(cell), {0.0, 0.0, 1.0});
}

}  // namespace hull

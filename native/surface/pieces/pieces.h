// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/limit_surface.h"

namespace hull::surface {

// A square within the unit square.
struct DomainSquare {
  double u, v, size;  // [u, u + size] x [v, v + size]
};

// A square of a cell on which the surface is one uniform bicubic B-spline span.
struct SurfacePiece {
  int cell;
  double u, v, size;     // [u, u + size] x [v, v + size] of the cell
  BicubicPoints points;  // of the span, parametrised over the square along the cell's u and v
};

// The square that is left at an irregular knot after some rings of pieces.
struct CornerSquare {
  int cell;
  double u, v, size;
  const CornerRing& ring;

  // Control points: the surface lies in their convex hull.
  const std::vector<Vector3d>& points() const { return ring.points(); }
  // Diagonal of the box around them, m.
  double extent() const;
};

namespace pieces_internal {

inline constexpr int kDeepestRing = 60;

// A square given as seen from corner `turn` of the unit square, in the unit square's own (u, v),
// and the same for a grid of control points.
DomainSquare turned_square(int turn, const DomainSquare& square);
BicubicPoints turned_points(int turn, const BicubicPoints& seen);
DomainSquare within(const DomainSquare& outer, const DomainSquare& inner);

template <class Descend, class Visit>
void visit_rings(const LimitSurface& surface, int cell, const SurfaceNode& node,
                 const DomainSquare& square, const Descend& descend, const Visit& visit) {
  const CornerBasis& basis = surface.layout().basis(node.index);
  CornerRing ring(basis, surface.corner(node.index));
  double size = 1.0;
  for (int level = 1; level <= kDeepestRing; ++level, size *= 0.5, ring.advance()) {
    const DomainSquare rest = within(square, turned_square(node.turn, {0.0, 0.0, size}));
    if (!descend(CornerSquare{cell, rest.u, rest.v, rest.size, ring})) return;
    for (int s = 0; s < basis.segment_count(); ++s) {
      const RingSegment& segment = basis.segments()[s];
      const DomainSquare seen{segment.u * size, segment.v * size, segment.size * size};
      const DomainSquare place = within(square, turned_square(node.turn, seen));
      visit(SurfacePiece{cell, place.u, place.v, place.size,
                         turned_points(node.turn, ring.segment_points(s))});
    }
  }
}

template <class Descend, class Visit>
void visit_node(const LimitSurface& surface, int cell, const SurfaceNode& node,
                const DomainSquare& square, const Descend& descend, const Visit& visit) {
  switch (node.kind) {
    case SurfaceNode::Kind::kLeaf:
      visit(SurfacePiece{cell, square.u, square.v, square.size, surface.leaf(node.index)});
      break;
    case SurfaceNode::Kind::kCorner:
      visit_rings(surface, cell, node, square, descend, visit);
      break;
    case SurfaceNode::Kind::kSplit: {
      const auto& children = surface.layout().split(node.index);
      for (int i = 0; i < 4; ++i) {
        visit_node(surface, cell, children[i], within(square, {0.5 * (i & 1), 0.5 * (i >> 1), 0.5}),
                   descend, visit);
      }
      break;
    }
  }
}

}  // namespace pieces_internal

// Calls visit(const SurfacePiece&) for pieces that together cover the cell but for squares at its
// irregular knots. descend(const CornerSquare&) is asked of each such square, from the whole cell
// or quadrant on, whether the next ring within it is wanted; it must at last say no (pieces end at
// 2^-60 of the cell).
template <class Descend, class Visit>
void for_each_piece(const LimitSurface& surface, int cell, const Descend& descend,
                    const Visit& visit) {
  pieces_internal::visit_node(surface, cell, surface.layout().root(cell), {0.0, 0.0, 1.0}, descend,
                              visit);
}

}  // namespace hull::surface

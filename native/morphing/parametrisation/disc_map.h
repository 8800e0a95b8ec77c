// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "morphing/parametrisation/convex_polygon.h"
#include "morphing/parametrisation/disc_sides.h"
#include "morphing/parametrisation/neighbour_weights.h"

namespace hull::morphing {

// A disc of triangles laid into a convex polygon of the plane, one to one: the border onto the
// sides, by chord lengths from corner to corner, each inner point at the mean of its neighbours by
// their weights (Floater 1997). It is linear on each triangle, and all triangles turn to the left,
// by exact predicates on the places as they are. Immutable.
class DiscMap {
 public:
  // `corners`: border points that become the polygon's corners, in the order of the border, which
  // has the surface to its left. An inner edge that joins two points of one side is divided, with
  // the triangles at it (split_chords): disc() is what is mapped.
  //
  // Throws std::invalid_argument for what border_points() and neighbour_weights() refuse, for
  // another number of corners than the polygon's, and, naming it, for a triangle that has no area
  // left in the plane, or turns over.
  DiscMap(const TriangleDisc& disc, std::vector<int> corners, ConvexPolygon polygon,
          WeightKind kind = WeightKind::kShapePreserving);

  // Points of the given disc keep their numbers; those in the middle of split_edges() follow.
  const TriangleDisc& disc() const { return split_.disc; }
  const std::vector<std::array<int, 2>>& split_edges() const { return split_.split_edges; }

  const ConvexPolygon& polygon() const { return polygon_; }
  const std::vector<int>& corners() const { return corners_; }
  // In order along the border from the first corner.
  const std::vector<BorderPoint>& border() const { return border_; }
  // Of each point of disc().
  const std::vector<Vector2d>& places() const { return places_; }

 private:
  void place_inner_points(WeightKind kind);
  void check_triangles() const;

  std::vector<int> corners_;
  ConvexPolygon polygon_;
  SplitDisc split_;
  std::vector<BorderPoint> border_;
  std::vector<Vector2d> places_;
};

}  // namespace hull::morphing

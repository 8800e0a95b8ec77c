// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "morphing/parametrisation/disc_map.h"

namespace hull::morphing {

// Two discs that were mapped onto one polygon as one mesh, which has the points and edges of both,
// and points where edges cross (Kang & Lee 2012): two surfaces of the same triangles, and those
// between them.
//
// Points: those of the first disc, those of the second that no point of the first lies on, then
// crossings. Triangles are parts of a triangle of each disc. Which points, edges and triangles
// there are follows from exact predicates on the places of both maps; where crossings are is
// rounded. With V points, E edges and F triangles, V - E + F = 1, and all triangles turn to the
// left in the plane with crossings as they are before rounding. Discs in the other order give the
// same mesh, in another order, to the last bit.
class MergedDiscs {
 public:
  // The discs of the maps with their divided edges. Throws std::invalid_argument for what
  // common_border() refuses, and for more than 5e7 crossings.
  MergedDiscs(const DiscMap& first, const DiscMap& second);

  int shared_count() const { return shared_count_; }      // points of both
  int crossing_count() const { return crossing_count_; }  // of inner edges
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // Of each triangle the triangles of both discs that it is part of.
  const std::vector<std::array<int, 2>>& parents() const { return parents_; }
  // Of each point the points of both discs that it is, or -1.
  const std::vector<std::array<int, 2>>& origins() const { return origins_; }
  const std::vector<Vector2d>& places() const { return places_; }

  // Where each point is on the first disc (0) or the second (1), m.
  const std::vector<Vector3d>& points_on(int disc) const { return points_[disc]; }
  // (1 - t) times those on the first and t times those on the second (Kang & Lee 2012, equation
  // 22), m. t may lie outside of 0 and 1.
  std::vector<Vector3d> points(double t) const;

 private:
  int shared_count_ = 0, crossing_count_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::array<int, 2>> parents_, origins_;
  std::vector<Vector2d> places_;
  std::array<std::vector<Vector3d>, 2> points_;
};

}  // namespace hull::morphing

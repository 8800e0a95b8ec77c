// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "surface/limit_surface.h"

namespace hull::surface {

// A dart's control point as subdivision moves it, level by level, by the smooth rule.
class DartWalk {
 public:
  // `h`: the half-edge that leaves the dart along its crease. The surface must outlive the walk.
  DartWalk(const LimitSurface& surface, int h);

  // After k steps: the dart's control point in the k times subdivided mesh.
  const Vector3d& point() const { return point_; }
  // Diagonal of a box that holds the surface, and the control points of this level along the
  // crease, from the dart to 2^-k control edges from it; infinite at the first levels.
  double extent() const { return extent_; }
  void advance();
  // The surface's point at the dart.
  const Vector3d& limit() const { return ring_->limit(); }

 private:
  void take_ring();

  std::array<Vector3d, 3> first_;  // what the corner's basis does not know: levels 0 … depth
  int depth_ = 0;                  // how often the dart's cell is split
  int level_ = 0;
  std::optional<CornerRing> ring_;
  Vector3d point_;
  double extent_;
};

}  // namespace hull::surface

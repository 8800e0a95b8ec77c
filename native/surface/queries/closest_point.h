// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "surface/queries/infinity.h"
#include "surface/queries/surface_tree.h"

namespace hull::surface {

// What the surface is like at the foot of a perpendicular.
enum class FootKind : std::uint8_t {
  kSmooth,  // p - foot is perpendicular to the surface
  kCrease,  // on a crease or border: p - foot is perpendicular to that at most
  kKnot     // at an irregular knot, or a corner: not perpendicular to anything in general
};

// The point of the surface nearest to a point p.
struct ClosestPoint {
  int cell = -1;  // -1: none within the search radius; then all else is as initialised
  double u = 0.0, v = 0.0;
  Vector3d point = Vector3d::Zero();
  double distance = kInfinity;  // m, never negative
  // No point of the surface is nearer than distance - gap: 1e-14 of the size, or more after very
  // many steps (see closest_point()).
  double gap = 0.0;
  FootKind kind = FootKind::kSmooth;
  // +1 where p is on the side of the normal at the foot, -1 on the other one; 0 where p - foot has
  // no part along it to speak of (1e-9 of the distance; p beyond a border or on the surface) or
  // where there is no normal. On a crease the normal is that of `cell`: for the foot of a
  // perpendicular both sides of a crease tell the same.
  int side = 0;
};

// The nearest of all points of the surface that are no farther than `max_distance`. The minimum is
// global: pieces are left out only where their control points prove that nothing nearer lies there,
// and one local minimum is taken for a piece's only one where its squared distance is proved
// convex.
//
// Errors: the distance is that of a point of the surface, to 1e-15 of SurfaceTree::error_size(),
// and no more than `gap` above the least. The foot is less certain where p is near a centre of
// curvature: moving it hardly changes the distance there. Of several feet at the same distance to
// `gap` any may be returned, always the same one for the same tree and arguments. Near irregular
// knots of high valence away from (0, 0), (u, v) are coarser than `point`: 1e-16, where the surface
// may turn by more.
//
// Work is bounded: after 2,000 pieces and parts of pieces (p near the centre of a sphere, say), gap
// is doubled at every further 500, and a foot within gap of max_distance may be missed. Over
// irregular knots, where pieces shrink without end, a query may take a millisecond, and 70 at
// valence 64.
//
// Throws std::invalid_argument unless p is finite and max_distance >= 0.
ClosestPoint closest_point(const SurfaceTree& tree, const Vector3d& p,
                           double max_distance = kInfinity);

// The same for each of many points; quicker when they follow one another along the surface, as
// points of a scan do. Between feet that are equal to `gap` the choice may depend on the points
// before. Messages name the index of the point.
std::vector<ClosestPoint> closest_points(const SurfaceTree& tree,
                                         const std::vector<Vector3d>& points,
                                         double max_distance = kInfinity);

}  // namespace hull::surface

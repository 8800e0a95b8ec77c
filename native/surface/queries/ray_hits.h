// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "surface/queries/infinity.h"
#include "surface/queries/surface_tree.h"

namespace hull::surface {

// A half-line, or a stretch of it: origin + t direction, t in metres.
struct Ray {
  Vector3d origin, direction;  // the direction need not be a unit vector; t counts as if it were
  double t_min = 0.0, t_max = kInfinity;
};

// A point that a ray and the surface share.
struct RayHit {
  double t = kInfinity;  // m along the ray
  int cell = -1;
  double u = 0.0, v = 0.0;
  Vector3d point = Vector3d::Zero();  // of the surface
  // The ray touches the surface here, or runs along it from or up to here, rather than cross it.
  bool grazing = false;
};

// Hits of a ray, exact: where two bicubic functions, the distances from two planes through the ray,
// vanish together. Pieces are left out only where their control points prove that they are passed,
// and one solution is taken for a piece's only one where that is proved. With s =
// SurfaceTree::error_size():
//
// - No gaps: everything that comes within 1e-13 s of the ray counts, so that rays at sides and
//   corners of cells, at creases, borders and irregular knots hit.
// - Hits of several pieces and cells at their common side or corner are one: those whose t differ
// by
//   no more than that tolerance makes them. Two sheets that are not that far apart count once.
// - A ray that touches the surface, or crosses it twice within 2e-7 s where it nearly touches,
// gives
//   one hit or two, marked as grazing where not told apart.
// - A ray that runs along the surface, within 1e-13 s of a flat side or of a straight line of it,
//   hits it where it comes to it and where it leaves it; both are grazing.
// - t and point are off by 1e-13 s, divided by the sine of the angle between ray and surface.
//
// Work is bounded as in closest_point.h: beyond 4,000 parts of pieces, which takes a ray that
// touches the surface along a curve, touching points are told apart less and less finely.
//
// Throw std::invalid_argument unless origin and direction are finite, the direction has a length,
// and t_min and t_max are numbers.

// The hit of least t within [t_min, t_max]; of several at the same t any, but always the same one.
std::optional<RayHit> first_ray_hit(const SurfaceTree& tree, const Ray& ray);

// All hits within [t_min, t_max], in order of t.
std::vector<RayHit> all_ray_hits(const SurfaceTree& tree, const Ray& ray);

}  // namespace hull::surface

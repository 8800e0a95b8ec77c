// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/models/closed_model.h"
#include "surface/progress.h"

namespace hull::production {

// A model with hollows in it.
struct HollowModel {
  ClosedModel model;         // the given one with the hollows' surfaces, turned into them
  int hollows = 0;           // how many are apart from one another
  double hollow_volume = 0;  // the model's is the given one's less this
};

inline constexpr double kMostWallCells = 3e6;

// Hollows wherever a body is more than `wall` away from its surface: the wall is as thick as that
// everywhere, and what is nowhere thicker than twice that stays solid, so that the inner surface
// never meets itself. It is where the distance from the triangles is `wall`, found on a grid of
// cubes of side `cell` none of which it can miss, and made of triangles within tetrahedra of these
// (marching tetrahedra, Freudenthal's division). Their corners are where the distance is `wall` on
// the tetrahedra's sides, so that triangles never cross one another: the wall is off by the square
// of `cell` over the radius of the inner surface; along its knuckles, which are cut off within a
// cube, by less than `cell`, on the thicker side.
//
// Throws std::invalid_argument unless both lengths are positive and `cell` is at most `wall`, for
// more than kMostWallCells cubes, naming what would do, and where nothing is thicker than twice the
// wall.
HollowModel hollowed(const ClosedModel& model, double wall, double cell,
                     const surface::Progress& progress = {});

// The volume of what is nearer than `wall` to the surface, inside, but for wall^3 (Steiner's
// formula): area · wall - (sum of tan(theta / 2) l over edges where the body is convex, of theta /
// 2 l, which is negative, where it is hollow) · wall^2, theta the angle between the triangles'
// normals and l the edges' length. Of a smooth surface the sum is the integral of the mean
// curvature.
double wall_volume(const ClosedModel& model, double wall);

}  // namespace hull::production

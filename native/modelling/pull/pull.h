// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/pull/pull_spread.h"
#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// A point of the surface, by its place, and where it is wanted.
struct PullTarget {
  int cell;
  double u, v;
  Vector3d point;  // m
};

// Control points that move, rising, and by what, m.
struct Pull {
  std::vector<int> points;
  std::vector<Vector3d> moves;
  double miss;   // largest distance of a target from where its place comes to lie, m
  double reach;  // the largest move of a control point, divided by the largest pull of a place
};

// Pulls places of the surface to targets: of all moves of the control points that take every place
// to its target and stay within the limits, the one with the least Σ |move|². With the weights w of
// the control points in a place (point_weights.h) that is a linear least-norm problem: the moves
// are B (W B)⁺ r for the weights W, the basis B of all moves within the limits (move_space.h) and
// the targets' distances r. Only control points with a weight in a place move, and such as limits
// tie to them.
//
// With a radius the control points around follow, too, as pull_spread.h says: each place has one
// vector, and these are such that all places are met all the same. There are as many unknowns as
// equations then.
//
// Places land within 1e-13 of the mesh's size, or of the largest pull. `reach` says how far this
// carries control points: 1 to 4 within faces; hundreds where a place hangs by the small weights of
// the few points that are not locked.
//
// Throws std::invalid_argument, naming the target, where the limits allow no such move (directions
// in which a place can be moved by less than 1e-6 of its control points' moves count as held) or
// targets contradict one another; for places, points, normals or a radius that are none.
Pull pull(const surface::LimitSurface& surface, const std::vector<PullTarget>& targets,
          const ReshapeLimits& limits = {}, const PullSpread& spread = {});

}  // namespace hull::modelling

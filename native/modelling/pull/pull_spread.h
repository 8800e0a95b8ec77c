// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "modelling/freedom.h"
#include "surface/eigenbasis/weight_row.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// How far around a pulled place control points follow it.
struct PullSpread {
  // Control points this near to the place follow, the less the farther they are, m; 0: only those
  // with a weight in the place.
  double radius = 0.0;
  // The mesh is one half of a hull whose other half is its mirror image across y = 0, and the pull
  // there reaches over to this side: the surface stays smooth across the plane.
  bool mirrored = false;
};

// Throws std::invalid_argument unless the radius is 0 or more, and finite.
void check_spread(const PullSpread& spread);

// How the control points around a place follow: point i moves by the matrix of i times one vector
// for the whole pull. By number; no others follow.
using Following = std::map<int, Eigen::Matrix3d>;

// With a radius R and the distance d from the place, φ = (1 - d²/R²)³ and its two first derivatives
// are zero at d = R. The matrix is φ Q + (1 - max φ) w / max(w) P for the weight w of the point in
// the place, and P onto what the point may do; the maxima are of all points with a weight. So a
// radius below the distances of these gives the least-norm pull.
//
// Q is P where no point is held. It fades out towards points that are, in the directions in which
// they are, so that no step in the moves is left beside them: (1 + S)^-1 with a stiffness S that
// is infinite at the held point and zero where the distance from it is that of the place.
//
// Locked points, and what can be come by along edges only over these, do not follow. REQUIRES:
// `weights` of the place, `place` in m, `freedoms` of all points, a radius above 0.
Following following(const surface::LimitSurface& surface,
                    const std::vector<surface::PointWeight>& weights, const Eigen::Vector3d& place,
                    const std::vector<Freedom>& freedoms, const PullSpread& spread);

}  // namespace hull::modelling

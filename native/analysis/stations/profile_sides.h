// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "analysis/stations/section_integrals.h"

namespace hull::analysis {

// Calls visit(a, b) with the cubics of the sides of a port piece that lie in the plane of the
// profile, run through with the piece on their left: their coordinates along two directions,
// from `origin`.
template <class Visit>
void for_each_side_in_plane(const ArcPiece& piece, const Vector3d& across, const Vector3d& up,
                            const Vector3d& origin, const Visit& visit) {
  constexpr int kSides[4][4] = {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};
  const surface::BicubicPoints& points = piece.piece.points;
  for (const auto& side : kSides) {
    const auto in_plane = [&](int k) { return piece.h[k] == 0.0; };
    if (!std::all_of(side, side + 4, in_plane)) continue;
    const BezierNet a = bezier_net(points, across, across.dot(origin));
    const BezierNet b = bezier_net(points, up, up.dot(origin));
    BezierCubic side_a, side_b;
    for (int i = 0; i < 4; ++i) {
      side_a[i] = a[side[i]];
      side_b[i] = b[side[i]];
    }
    visit(side_a, side_b);
  }
}

}  // namespace hull::analysis

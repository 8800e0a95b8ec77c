// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace hull::production {

using PointLoop = std::vector<int>;  // numbers of points; the first is not repeated

// Closed loops of directed sides, each side once. Where several sides leave a point the one that
// turns furthest to the left goes on, so that loops that touch in a point stay apart. `places`: by
// point. REQUIRES: as many sides end in each point as leave it.
std::vector<PointLoop> chained(const std::vector<std::pair<int, int>>& sides,
                               const std::vector<Eigen::Vector2d>& places);

// Twice the area that a loop encloses, positive where it runs counter-clockwise.
double doubled_area(const PointLoop& loop, const std::vector<Eigen::Vector2d>& places);

// Triangles of what lies to the left of loops, counter-clockwise around regions and clockwise
// around holes in them, with the loops' own points and sides alone: ears are cut off (Meisters
// 1975), holes being joined to what is around them first (Eberly 2008). Whatever the loops are,
// each of their sides is one of just one triangle, and each other side is one of two: what is
// closed so stays closed, and encloses the volume that it should, even where loops have no area.
std::vector<std::array<int, 3>> filled(const std::vector<PointLoop>& loops,
                                       const std::vector<Eigen::Vector2d>& places);

}  // namespace hull::production

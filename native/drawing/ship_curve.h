// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines in ship axes: parts on one side of a plane.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull {

enum class Side { kBelow, kAbove };

// The parts of the polyline `curve` whose coordinate `axis` (0, 1, 2) is at most (kBelow) or at
// least (kAbove) `limit`, each with its end points put exactly on the limit where it was cut. A
// part of a single point is dropped. A curve that lies in the limiting plane is kept whole by both
// sides.
std::vector<std::vector<Eigen::Vector3d>> part_of_curve(const std::vector<Eigen::Vector3d>& curve,
                                                        int axis, double limit, Side side);

}  // namespace hull

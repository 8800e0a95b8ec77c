// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in ship axes: parts on one side of a plane.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/creases/cubic_spline.h"

namespace hull::drawing {

// A curve by points on it and, where it is known, as a cubic B-spline from the first to the last of
// them. Paper is drawn from the points, files that know splines get those.
struct ShipCurve {
  std::vector<Eigen::Vector3d> points;
  std::optional<surface::CubicSpline> spline;
};

enum class LimitSide { kBelow, kAbove };

// The parts of the polyline `curve` whose coordinate `axis` (0, 1, 2) is at most (kBelow) or at
// least (kAbove) `limit`, each with its end points put exactly on the limit where it was cut. A
// part of a single point is dropped. A curve that lies in the limiting plane is kept whole by both
// sides.
std::vector<std::vector<Eigen::Vector3d>> part_of_curve(const std::vector<Eigen::Vector3d>& curve,
                                                        int axis, double limit, LimitSide side);

// The same with splines. A part is left without one where points and spline disagree about the
// parts there are, as where a curve only just reaches over the limit.
std::vector<ShipCurve> part_of_curve(const ShipCurve& curve, int axis, double limit,
                                     LimitSide side);

// The parts that are to port of the plane y = `least`, just off the centre plane. A curve of which
// only an end is nearer keeps its spline up to there: in files it meets the centre plane.
std::vector<ShipCurve> parts_off_centre(const ShipCurve& curve, double least);

}  // namespace hull::drawing

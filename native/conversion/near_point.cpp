// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/near_point.h"

#include <Eigen/LU>
#include <algorithm>

namespace hull {
namespace {

constexpr int kMaxSteps = 12;
constexpr double kWorthwhile = 0.99;  // a step that gains less than 1 % is the last one

}  // namespace

// Gauss-Newton, kept within the cell. Every point of the surface gives an upper bound, so it does
// not matter how far the search comes.
NearPoint near_point(const LimitSurface& surface, const Vector3d& point, const CellPoint& start,
                     double enough) {
  NearPoint found{start, (point - surface.position(start.cell, start.u, start.v)).norm()};
  auto& [cell, u, v] = found.place;
  for (int step = 0; step < kMaxSteps && found.distance > enough; ++step) {
    const SurfaceJet jet = surface.evaluate(cell, u, v, 1);
    Eigen::Matrix<double, 3, 2> slope;
    slope << jet.du, jet.dv;
    Eigen::Matrix2d normal = slope.transpose() * slope;
    if (!(normal.trace() > 0.0)) break;  // an irregular corner has no derivatives
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::Vector2d move = normal.inverse() * slope.transpose() * (point - jet.point);
    const double next_u = std::clamp(u + move.x(), 0.0, 1.0);
    const double next_v = std::clamp(v + move.y(), 0.0, 1.0);
    const double next = (point - surface.position(cell, next_u, next_v)).norm();
    if (!(next < found.distance)) break;
    const bool worthwhile = next < kWorthwhile * found.distance;
    found = {{cell, next_u, next_v}, next};
    if (!worthwhile) break;
  }
  return found;
}

}  // namespace hull

// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/near_point.h"

#include <Eigen/LU>
#include <algorithm>

namespace hull::conversion {
namespace {

constexpr int kMaxSteps = 12;
// Near irregular corners the surface turns within the length of a step.
constexpr int kMaxHalvings = 6;
constexpr double kWorthwhile = 0.99;  // a step that gains less than 1 % is the last one

}  // namespace

// Gauss-Newton with shortened steps, kept within the cell. Every point of the surface gives an
// upper bound, so it does not matter how far the search comes.
NearPoint near_point(const RingedSurface& surface, const Vector3d& point, const CellPoint& start,
                     double enough) {
  NearPoint found{start, (point - surface.position(start.cell, start.u, start.v)).norm()};
  auto& [cell, u, v] = found.place;
  for (int step = 0; step < kMaxSteps && found.distance > enough; ++step) {
    const surface::SurfaceJet jet = surface.evaluate(cell, u, v, 1);
    Eigen::Matrix<double, 3, 2> slope;
    slope << jet.du, jet.dv;
    Eigen::Matrix2d normal = slope.transpose() * slope;
    if (!(normal.trace() > 0.0)) break;  // an irregular corner has no derivatives
    // Where u and v run the same way the step is along both.
    normal.diagonal().array() += 1e-12 * normal.trace();
    Eigen::Vector2d move = normal.inverse() * slope.transpose() * (point - jet.point);
    NearPoint next = found;
    for (int halving = 0; halving < kMaxHalvings && !(next.distance < found.distance); ++halving) {
      next.place = {cell, std::clamp(u + move.x(), 0.0, 1.0), std::clamp(v + move.y(), 0.0, 1.0)};
      next.distance = (point - surface.position(cell, next.place.u, next.place.v)).norm();
      move *= 0.5;
    }
    if (!(next.distance < found.distance)) break;
    const bool worthwhile = next.distance < kWorthwhile * found.distance;
    found = next;
    if (!worthwhile) break;
  }
  return found;
}

}  // namespace hull::conversion

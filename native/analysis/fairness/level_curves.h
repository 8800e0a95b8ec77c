// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "analysis/fairness/surface_field.h"

namespace hull::analysis {

// A curve on the surface along which a function of point and normal has one value.
struct LevelCurve {
  double level;
  std::vector<Vector3d> points;     // m, in order
  std::vector<int> cells;           // per point …
  std::vector<Eigen::Vector2d> uv;  // … and where in that cell
  bool closed;                      // the first point is then repeated at the end
};

struct LevelOptions {
  int divisions = 8;  // each cell is looked at on a grid of so many squares a side
  double chord_tolerance = std::numeric_limits<double>::infinity();  // m, between points
};

// Values that a period apart mean the same, as angles do.
inline constexpr double kNoPeriod = std::numeric_limits<double>::infinity();

// The level curves of a function. They run with greater values on their left, seen from outside.
//
// Found between the points of the cells' grids: what comes and goes within a square of the grid is
// not found. Every point is then refined on the exact surface, with its exact normal, to rounding.
// Curves end at creases, where the normal jumps, at borders, and where the function is not a
// number; of regions with the very value the border is given. Throws std::invalid_argument for
// divisions outside of 1 to 64, a chord tolerance that is not positive, levels that are not finite.
std::vector<LevelCurve> level_curves(const surface::LimitSurface& surface,
                                     const NormalFunction& function,
                                     const std::vector<double>& levels, const LevelOptions& options,
                                     double period = kNoPeriod);

}  // namespace hull::analysis

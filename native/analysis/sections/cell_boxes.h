// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"

namespace hull::analysis {

// Axis-aligned boxes around the cells of a surface, from their control points: what a query need
// not look at.
class CellBoxes {
 public:
  explicit CellBoxes(const surface::LimitSurface& surface);

  // After set_points() of the same surface.
  void update(const surface::LimitSurface& surface);

  int size() const { return static_cast<int>(low_.size()); }
  // Bounds of direction·p over a cell.
  double least(int cell, const Vector3d& direction) const {
    return pick(direction, low_[cell], high_[cell]);
  }
  double most(int cell, const Vector3d& direction) const {
    return pick(direction, high_[cell], low_[cell]);
  }
  const Vector3d& low(int cell) const { return low_[cell]; }
  const Vector3d& high(int cell) const { return high_[cell]; }

 private:
  // The dot product with the corner that has `along` where the direction is positive.
  static double pick(const Vector3d& direction, const Vector3d& along, const Vector3d& against) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      sum += direction[k] * (direction[k] > 0.0 ? along[k] : against[k]);
    }
    return sum;
  }
  void take(const surface::LimitSurface& surface, int cell);
  void add(const surface::LimitSurface& surface, const surface::SurfaceNode& node, int cell);

  std::vector<Vector3d> low_, high_;
  int revision_;
};

}  // namespace hull::analysis

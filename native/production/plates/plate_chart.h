// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "production/plates/plate_mesh.h"

namespace hull::production {

// Smooth coordinates in the plane for a plate that turns to all sides, even by more than a right
// angle: points are projected from a centre or from an axis, far or near, and the sphere or the
// cylinder around it is unrolled.
class PlateChart {
 public:
  struct Value {
    Eigen::Vector2d at;                  // m
    Eigen::Matrix<double, 2, 3> slopes;  // by the point
  };
  Value value(const Vector3d& point) const;

  // The chart of some kinds and distances that distorts the plate least; none where each of them
  // folds it. `is_mirrored`: the points are symmetric about y = 0, and so is the chart.
  static std::optional<PlateChart> best(const std::vector<PlatePoint>& points, bool is_mirrored);

 private:
  enum class Kind { kPlane, kAxis, kCentre };
  double quality(const std::vector<PlatePoint>& points) const;

  Kind kind_ = Kind::kPlane;
  Vector3d origin_, along_, across_, normal_;
  double distance_ = 0.0;  // of the axis or centre, inwards
};

}  // namespace hull::production

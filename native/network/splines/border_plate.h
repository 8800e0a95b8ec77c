// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "network/patches/ribboned_side.h"

namespace hull::network {

// A place on a region's border, in its order: the surface's unit normal there, and whether its
// slope across the border is to be met (at corners it follows from the borders).
struct PlateSample {
  Vector3d point, along, normal;
  bool has_slope;
};

// The heights over a mean plane of a smooth surface that has given points and normals along a
// closed border: radial functions r⁵ with a quadratic polynomial (Hermite interpolation by a
// conditionally positive definite function; Wendland 2005, 16.2). It reproduces quadratic heights.
// Without normals: r³ with a linear polynomial, which reproduces planes.
class BorderPlate {
 public:
  // None where the border is no graph over a plane: where a normal is more than about 75° off the
  // mean one.
  static std::optional<BorderPlate> within(const std::vector<PlateSample>& border,
                                           bool has_normals);

  Vector2d place(const Vector3d& point) const;  // in the plane, of which 1 is about half the size
  // By the place's coordinates.
  PatchPoint at(const Vector2d& place) const;
  // Of the border's polygon.
  Vector2d centre() const { return centre_; }
  // Whether it is nowhere steeper, of some places, than borders may be.
  bool is_gentle(const std::vector<Vector2d>& places) const;

 private:
  struct Source {
    Vector2d at;
    Vector2d across;  // the slope's direction; zero: the height
  };

  BorderPlate() = default;
  void solve(const Eigen::VectorXd& wanted);
  Eigen::Index polynomial_count() const { return has_normals_ ? 6 : 3; }

  Vector3d origin_ = Vector3d::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  // columns: in the plane, and up
  double scale_ = 1.0;
  Vector2d centre_ = Vector2d::Zero();
  std::vector<Source> sources_;
  bool has_normals_ = true;
  Eigen::VectorXd weights_;  // of sources and of 1, x, y, x², xy, y², or of 1, x, y
};

}  // namespace hull::network

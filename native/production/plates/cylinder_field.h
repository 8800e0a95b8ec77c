// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "surface/pieces/bezier_patch.h"

namespace hull::production {

// A circular cylinder without ends: a bow thruster's tunnel, a stern tube.
struct Cylinder {
  Vector3d point;      // of its axis
  Vector3d direction;  // of its axis, unit
  double radius;       // m
};

// Space seen along a cylinder's axis, which is the third one: the cylinder is x² + y² = r².
class CylinderFrame {
 public:
  explicit CylinderFrame(const Cylinder& cylinder);

  Vector3d across(int axis) const { return axes_.col(axis); }
  Vector3d origin() const { return origin_; }
  double radius() const { return radius_; }
  Vector3d seen(const Vector3d& p) const { return axes_.transpose() * (p - origin_); }
  Vector3d unseen(const Vector3d& direction) const { return axes_ * direction; }
  // A span of the surface with its control points seen so.
  surface::BezierPatch seen(const surface::BicubicPoints& points) const;
  // How far a box in the first two axes is from the axis, at least and at most.
  std::array<double, 2> distances(const Eigen::AlignedBox2d& box) const;

 private:
  Eigen::Matrix3d axes_;
  Vector3d origin_;
  double radius_;
};

// x² + y² - r² over a part of the surface that is seen so, by its Bernstein coefficients of degree
// six in u and v: positive outside the cylinder.
class CylinderField {
 public:
  static constexpr int kOrder = 7;

  // What is less than `zero` (m²) in absolute value is rounding, and zero.
  CylinderField(const surface::BezierPatch& seen, double radius, double zero);

  double lowest() const;
  double highest() const;
  // The least and the largest difference of coefficients that follow along u (axis 0) or v (1).
  std::array<double, 2> slopes(int axis) const;
  // The coefficients on the side u = 0 or 1 (axis 0), or v = 0 or 1 (axis 1).
  std::array<double, kOrder> side(int axis, int end) const;

 private:
  std::array<double, kOrder * kOrder> c_{};  // 7 j + i, i along u
};

}  // namespace hull::production

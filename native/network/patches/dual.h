// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "mesh/vectors.h"

namespace hull::network {

// A number that depends on two coordinates, with its derivatives by them.
struct Dual {
  double value = 0.0;
  Eigen::Vector2d by = Eigen::Vector2d::Zero();
};

inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.by + b.by}; }
inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.by - b.by}; }
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.by + b.value * a.by};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double value = a.value / b.value;
  return {value, (a.by - value * b.by) / b.value};
}
inline Dual operator-(double a, const Dual& b) { return {a - b.value, -b.by}; }

// A place that does.
struct DualPlace {
  Vector3d value = Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> by = Eigen::Matrix<double, 3, 2>::Zero();
};

inline DualPlace operator+(const DualPlace& a, const DualPlace& b) {
  return {a.value + b.value, a.by + b.by};
}
inline DualPlace operator-(const DualPlace& a, const DualPlace& b) {
  return {a.value - b.value, a.by - b.by};
}
inline DualPlace operator*(const Dual& a, const DualPlace& b) {
  return {a.value * b.value, a.value * b.by + b.value * a.by.transpose()};
}

// What stands at a parameter of a curve, with its derivative by that.
inline DualPlace along(const Vector3d& value, const Vector3d& slope, const Dual& parameter) {
  return {value, slope * parameter.by.transpose()};
}
inline DualPlace fixed(const Vector3d& value) {
  return {value, Eigen::Matrix<double, 3, 2>::Zero()};
}

}  // namespace hull::network

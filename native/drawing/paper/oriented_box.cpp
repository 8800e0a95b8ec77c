// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/oriented_box.h"

#include <algorithm>
#include <cmath>

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

Vector2d along(const OrientedBox& box) { return {std::cos(box.angle), std::sin(box.angle)}; }

Vector2d across(const OrientedBox& box) { return {-std::sin(box.angle), std::cos(box.angle)}; }

// Half the extent of the box when it is projected on the unit vector `axis`.
double reach(const OrientedBox& box, const Vector2d& axis) {
  return box.half.x() * std::abs(along(box).dot(axis)) +
         box.half.y() * std::abs(across(box).dot(axis));
}

bool separated_by(const Vector2d& axis, const OrientedBox& a, const OrientedBox& b) {
  return std::abs((b.centre - a.centre).dot(axis)) >= reach(a, axis) + reach(b, axis);
}

}  // namespace

std::array<Vector2d, 4> OrientedBox::corners() const {
  const Vector2d u = along(*this) * half.x();
  const Vector2d v = across(*this) * half.y();
  return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

OrientedBox OrientedBox::grown(double margin) const {
  return {centre, half + Vector2d::Constant(margin), angle};
}

// Convex shapes are apart exactly if they are so along the normal of one of their sides (separating
// axes); a box has two directions of these.
bool overlap(const OrientedBox& a, const OrientedBox& b) {
  return !(separated_by(along(a), a, b) || separated_by(across(a), a, b) ||
           separated_by(along(b), a, b) || separated_by(across(b), a, b));
}

bool overlap(const OrientedBox& box, const Vector2d& a, const Vector2d& b) {
  // The clipping of Liang and Barsky 1984 in the frame of the box: the part of the segment within
  // both slabs.
  const Vector2d u = along(box), v{-u.y(), u.x()};
  const Vector2d start{(a - box.centre).dot(u), (a - box.centre).dot(v)};
  const Vector2d end{(b - box.centre).dot(u), (b - box.centre).dot(v)};
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = end[axis] - start[axis];
    // Exactly along the slab there is no crossing: it is all in or all out.
    if (step == 0.0) {
      if (std::abs(start[axis]) >= box.half[axis]) return false;
      continue;
    }
    const double t0 = (-box.half[axis] - start[axis]) / step;
    const double t1 = (box.half[axis] - start[axis]) / step;
    first = std::max(first, std::min(t0, t1));
    last = std::min(last, std::max(t0, t1));
  }
  return first < last;
}

}  // namespace hull::drawing

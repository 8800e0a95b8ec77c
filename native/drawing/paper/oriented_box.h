// SPDX-License-Identifier: GPL-3.0-or-later
// Rectangles at any angle on the page, in millimetres: what a label occupies. Page axes are x to
// the right and y down, as on screen and in SVG; an angle turns x towards y.
#pragma once

#include <Eigen/Core>
#include <array>

namespace hull::drawing {

struct OrientedBox {
  Eigen::Vector2d centre;
  Eigen::Vector2d half;  // half the width and half the height, before turning
  double angle = 0.0;    // radians

  std::array<Eigen::Vector2d, 4> corners() const;

  // The same box with `margin` more on every side; a negative margin shrinks it.
  OrientedBox grown(double margin) const;
};

// Whether the boxes share a point of their insides; touching sides do not count.
bool overlap(const OrientedBox& a, const OrientedBox& b);

// Whether the segment from a to b passes through the inside of the box.
bool overlap(const OrientedBox& box, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace hull::drawing

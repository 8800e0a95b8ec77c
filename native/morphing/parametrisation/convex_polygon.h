// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "morphing/orientation.h"

namespace hull::morphing {

// A polygon of the plane that turns to the left at each of its corners, once around; exactly so for
// the corners as they are.
class ConvexPolygon {
 public:
  // Throws std::invalid_argument, naming the corner, for fewer than three corners, for what is no
  // number, and where it does not turn to the left.
  explicit ConvexPolygon(std::vector<Vector2d> corners);

  // On the unit circle from (1, 0), over arcs in proportion to lengths, such as those of the sides
  // of a disc: of three sides or more. Throws std::invalid_argument unless all are positive.
  static ConvexPolygon on_circle(const std::vector<double>& lengths);

  const std::vector<Vector2d>& corners() const { return corners_; }
  int side_count() const { return static_cast<int>(corners_.size()); }
  // The diagonal of its box.
  double size() const;
  // On side k, from corner k (0) to corner k + 1 (1), to rounding.
  Vector2d on_side(int side, double along) const;

 private:
  std::vector<Vector2d> corners_;
};

}  // namespace hull::morphing

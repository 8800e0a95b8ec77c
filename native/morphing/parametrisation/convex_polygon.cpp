// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/convex_polygon.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace hull::morphing {

ConvexPolygon::ConvexPolygon(std::vector<Vector2d> corners) : corners_(std::move(corners)) {
  const int count = side_count();
  if (count < 3) {
    throw std::invalid_argument("The polygon has " + std::to_string(count) +
                                " corners: give it three or more.");
  }
  for (int k = 0; k < count; ++k) {
    // Far below the largest coordinates for which orientation() is exact.
    if (corners_[k].allFinite() && corners_[k].cwiseAbs().maxCoeff() < 1e100) continue;
    throw std::invalid_argument("Corner " + std::to_string(k) +
                                " of the polygon is no place: give it two numbers below 1e100.");
  }
  for (int k = 0; k < count; ++k) {
    const Vector2d &next = corners_[(k + 1) % count], &last = corners_[(k + 2) % count];
    // The second is negative somewhere where a polygon goes round twice.
    const bool turns = orientation(corners_[k], next, last) > 0.0;
    const bool sees = k == 0 || k + 1 >= count || orientation(corners_[0], corners_[k], next) > 0.0;
    if (turns && sees) continue;
    throw std::invalid_argument("The polygon does not turn to the left at corner " +
                                std::to_string((k + 1) % count) +
                                ", or goes round more than once: it must be convex, its corners "
                                "counter-clockwise.");
  }
}

ConvexPolygon ConvexPolygon::on_circle(const std::vector<double>& lengths) {
  double sum = 0.0;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    if (!(lengths[k] > 0.0) || !std::isfinite(lengths[k])) {
      throw std::invalid_argument("Side " + std::to_string(k) +
                                  " of the polygon must have a length above 0.");
    }
    sum += lengths[k];
  }
  std::vector<Vector2d> corners;
  double before = 0.0;
  for (double length : lengths) {
    // Corners on a circle, in order, turn to the left whatever their arcs.
    const double angle = 2.0 * std::numbers::pi * (before / sum);
    corners.emplace_back(std::cos(angle), std::sin(angle));
    before += length;
  }
  return ConvexPolygon(std::move(corners));
}

double ConvexPolygon::size() const {
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : corners_) box.extend(corner);
  return box.diagonal().norm();
}

Vector2d ConvexPolygon::on_side(int side, double along) const {
  const Vector2d &from = corners_[side], &to = corners_[(side + 1) % side_count()];
  // What is added to the beginning may round beside the end.
  if (along == 1.0) return to;
  return from + along * (to - from);
}

}  // namespace hull::morphing

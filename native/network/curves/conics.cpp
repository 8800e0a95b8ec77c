// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/conics.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hull::network {
namespace {

constexpr double kStraight = 1e-12;  // sine of an angle between directions of one line
// The square of a sine: tangents within 1e-6 rad of one line have no place where they meet.
constexpr double kParallel = 1e-12;
constexpr double kQuarter = 0.5 * std::numbers::pi;

// A circle with two directions of its plane at right angles, `first` to the arc's start.
struct Circle {
  Vector3d centre, first, second;  // of the radius' length
};

NurbsCurve arc_of(const Circle& circle, double angle, const Vector3d& start, const Vector3d& end) {
  // Rounding is not to make two parts of a quarter circle.
  const int count = std::max(1, static_cast<int>(std::ceil(angle / kQuarter - 1e-9)));
  const double half = 0.5 * angle / count, between = std::cos(half);
  Points3 points(2 * count + 1, 3);
  Eigen::VectorXd weights(points.rows());
  std::vector<double> knots{0.0};
  for (int i = 0; i <= 2 * count; ++i) {
    const bool is_apex = i % 2 == 1;
    // Tangents at the ends of an arc of twice the angle a meet at r / cos a, and the arc is the
    // conic whose weight there is cos a (Koelman 1999, 5.2.1).
    const double reach = is_apex ? 1.0 / between : 1.0;
    points.row(i) = circle.centre + reach * (std::cos(i * half) * circle.first +
                                             std::sin(i * half) * circle.second);
    weights[i] = is_apex ? between : 1.0;
    // The part's beginning, which is there twice; the first part's is there thrice, by the first
    // knot.
    if (is_apex) knots.insert(knots.end(), 2, static_cast<double>(i - 1) / (2 * count));
  }
  knots.insert(knots.end(), 3, 1.0);
  // Bit for bit what was given, as other curves may begin there.
  points.row(0) = start;
  points.row(points.rows() - 1) = end;
  return {2, std::move(knots), std::move(points), std::move(weights)};
}

void require_places(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  if (a.allFinite() && b.allFinite() && c.allFinite()) return;
  throw std::invalid_argument("A point of the arc is no place.");
}

}  // namespace

NurbsCurve conic_arc(const Vector3d& start, const Vector3d& apex, const Vector3d& end,
                     double fullness) {
  require_places(start, apex, end);
  const Vector3d a = apex - start, b = end - apex;
  // Equal ends are refused by this, too: then both ways are one line.
  if (!(a.cross(b).norm() > kStraight * a.norm() * b.norm())) {
    throw std::invalid_argument("The tangents at the ends of a conic must meet at an angle.");
  }
  if (!(fullness > 0.0) || !std::isfinite(fullness)) {
    throw std::invalid_argument("A conic's fullness must be above zero.");
  }
  // With S = (M + w apex) / (1 + w) for weights 1, w, 1 the fullness is the weight itself.
  Points3 points(3, 3);
  points << start.transpose(), apex.transpose(), end.transpose();
  return {
      2, {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}, std::move(points), Eigen::Vector3d(1.0, fullness, 1.0)};
}

std::optional<Apex> apex_of(const Vector3d& start, const Vector3d& along, const Vector3d& end,
                            const Vector3d& back) {
  const double c = along.dot(back), below = 1.0 - c * c;
  if (!(below > kParallel)) return std::nullopt;
  const Vector3d chord = end - start;
  const double s = (chord.dot(along) - c * chord.dot(back)) / below;
  const double t = (c * chord.dot(along) - chord.dot(back)) / below;
  return Apex{0.5 * (start + s * along + end + t * back),
              (start + s * along - end - t * back).norm()};
}

NurbsCurve arc_through(const Vector3d& start, const Vector3d& point, const Vector3d& end) {
  require_places(start, point, end);
  const Vector3d a = start - point, b = end - point, normal = b.cross(a);
  if (!(normal.norm() > kStraight * a.norm() * b.norm())) {
    throw std::invalid_argument("The three points of a circular arc are on a straight line.");
  }
  Circle circle;
  // The circumcentre, from one of the triangle's corners.
  circle.centre = point + (a.squaredNorm() * b - b.squaredNorm() * a).cross(a.cross(b)) /
                              (2.0 * normal.squaredNorm());
  circle.first = start - circle.centre;
  circle.second = normal.normalized().cross(circle.first);
  const Vector3d last = end - circle.centre;
  double angle = std::atan2(last.dot(circle.second), last.dot(circle.first));
  // The normal is that about which start, point and end turn to the left: so the arc is the one by
  // way of the point, be it more than half a circle.
  if (angle <= 0.0) angle += 2.0 * std::numbers::pi;
  return arc_of(circle, angle, start, end);
}

NurbsCurve arc_from_tangent(const Vector3d& start, const Vector3d& direction, const Vector3d& end) {
  require_places(start, direction, end);
  const Vector3d chord = end - start;
  // The part of the direction at right angles to the chord, to which the arc bulges.
  const Vector3d across = chord.cross(direction).cross(chord);
  const double sine = chord.cross(direction).norm(), cosine = chord.dot(direction);
  if (!(sine > kStraight * chord.norm() * direction.norm())) {
    throw std::invalid_argument(
        "The direction in which a circular arc leaves is that of its chord, or none.");
  }
  // Angle between chord and tangent: half the arc's; the middle of the arc is up by a quarter's.
  const double rise = 0.5 * chord.norm() * std::tan(0.5 * std::atan2(sine, cosine));
  // The middle of the arc is a third point of it.
  return arc_through(start, 0.5 * (start + end) + rise * across.normalized(), end);
}

}  // namespace hull::network

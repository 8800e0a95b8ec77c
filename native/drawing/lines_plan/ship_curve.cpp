// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/ship_curve.h"

#include <utility>

#include "drawing/lines_plan/ship_spline.h"

namespace hull::drawing {

using Eigen::Vector3d;

namespace {

Vector3d crossing(const Vector3d& a, const Vector3d& b, int axis, double limit) {
  const double t = (limit - a[axis]) / (b[axis] - a[axis]);
  Vector3d point = a + t * (b - a);
  point[axis] = limit;
  return point;
}

// The parts of the spline on the side.
std::vector<surface::CubicSpline> part_of(const surface::CubicSpline& spline, int axis,
                                          double limit, LimitSide side) {
  std::vector<double> ends = crossings_of_spline(spline, axis, limit);
  ends.insert(ends.begin(), spline.begin());
  ends.push_back(spline.end());
  std::vector<surface::CubicSpline> parts;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    // The spline begins or ends on the limit.
    if (!(ends[i - 1] < ends[i])) continue;
    const double middle = 0.5 * (ends[i - 1] + ends[i]);
    // No crossing lies within, so the middle tells for the whole part.
    const bool above = spline.evaluate(middle, 0).point[axis] >= limit;
    if (above == (side == LimitSide::kAbove)) {
      parts.push_back(part_of_spline(spline, ends[i - 1], ends[i]));
    }
  }
  return parts;
}

}  // namespace

std::vector<std::vector<Vector3d>> part_of_curve(const std::vector<Vector3d>& curve, int axis,
                                                 double limit, LimitSide side) {
  const auto kept = [&](const Vector3d& point) {
    return side == LimitSide::kAbove ? point[axis] >= limit : point[axis] <= limit;
  };
  std::vector<std::vector<Vector3d>> parts;
  std::vector<Vector3d> part;
  const auto finish = [&] {
    if (part.size() > 1) parts.push_back(part);
    part.clear();
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool now = kept(curve[i]);
    if (i > 0 && now != kept(curve[i - 1])) {
      const Vector3d& inside = now ? curve[i] : curve[i - 1];
      // Where the kept end is on the limit itself it is the crossing.
      if (inside[axis] != limit) part.push_back(crossing(curve[i - 1], curve[i], axis, limit));
      // A part that ends is closed by its crossing; one that begins has it as its first point.
      if (!now) finish();
    }
    if (now) part.push_back(curve[i]);
  }
  finish();
  return parts;
}

std::vector<ShipCurve> part_of_curve(const ShipCurve& curve, int axis, double limit,
                                     LimitSide side) {
  std::vector<ShipCurve> parts;
  for (std::vector<Vector3d>& points : part_of_curve(curve.points, axis, limit, side)) {
    parts.push_back({std::move(points), std::nullopt});
  }
  if (!curve.spline) return parts;
  // By all points: their number alone stays the same where a crossing replaces an end.
  if (parts.size() == 1 && parts.front().points == curve.points) {
    parts.front().spline = curve.spline;
    return parts;
  }
  std::vector<surface::CubicSpline> splines = part_of(*curve.spline, axis, limit, side);
  // Both run from the curve's begin to its end, so that the n-th is the same part in each.
  if (splines.size() != parts.size()) return parts;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].spline = std::move(splines[i]);
  return parts;
}

std::vector<ShipCurve> parts_off_centre(const ShipCurve& curve, double least) {
  std::vector<ShipCurve> parts = part_of_curve(curve, 1, least, LimitSide::kAbove);
  // As many points: at most an end was cut off, for which its crossing makes up.
  const bool is_whole = parts.size() == 1 && parts.front().points.size() == curve.points.size();
  if (is_whole) parts.front().spline = curve.spline;
  return parts;
}

}  // namespace hull::drawing

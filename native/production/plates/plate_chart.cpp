// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/plate_chart.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace hull::production {

namespace {

// Of the least and largest lengths in a chart: better ones are not looked for, worse ones fold.
constexpr double kGood = 0.6, kBad = 0.02;
constexpr int kDirections = 12;
constexpr double kDistances[] = {0.25, 0.35, 0.5, 0.7, 1.0, 1.5, 2.5, 5.0};  // of √area

}  // namespace

PlateChart::Value PlateChart::value(const Vector3d& point) const {
  const Vector3d q = point - origin_;
  const double x = q.dot(along_), y = q.dot(across_);
  Value v;
  v.at = {x, y};
  v.slopes << along_.transpose(), across_.transpose();
  if (kind_ == Kind::kPlane) return v;
  // A negative distance: the axis or centre is outside, for plates that are hollow.
  const double z = distance_ + q.dot(normal_), sign = std::copysign(1.0, distance_);
  if (kind_ == Kind::kAxis) {
    v.at.y() = distance_ * std::atan2(sign * y, sign * z);
    // The angle's gradient, times the distance, by which both directions have the same scale at the
    // origin.
    v.slopes.row(1) =
        distance_ / (y * y + z * z) * (z * across_.transpose() - y * normal_.transpose());
    return v;
  }
  // Stereographic: 2 d (x, y) / (r + z), r the distance from the centre.
  const Vector3d ray = q + distance_ * normal_;
  // Its gradient: -scale / (r + z) (grad r + n), grad r = ray / r.
  const double r = sign * ray.norm(), scale = 2.0 * distance_ / (r + z);
  const Vector3d of_scale = -scale / (r + z) * (ray / r + normal_);
  v.at *= scale;
  v.slopes = scale * v.slopes;
  v.slopes.row(0) += x * of_scale.transpose();
  v.slopes.row(1) += y * of_scale.transpose();
  return v;
}

// The least length in the chart over the largest, of all directions; 0 where a point is folded
// over.
double PlateChart::quality(const std::vector<PlatePoint>& points) const {
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (const PlatePoint& p : points) {
    const Eigen::Matrix2d f = value(p.at).slopes * p.tangents;
    if (!(f.determinant() > 0.0)) return 0.0;
    const Vector2d values = f.jacobiSvd().singularValues();
    least = std::min(least, values[1]);
    largest = std::max(largest, values[0]);
  }
  // A ratio: the chart's own scale does not matter.
  return least / largest;
}

std::optional<PlateChart> PlateChart::best(const std::vector<PlatePoint>& points,
                                           bool is_mirrored) {
  double area = 0.0;
  Vector3d centre = Vector3d::Zero(), normal = Vector3d::Zero();
  for (const PlatePoint& p : points) {
    area += p.area;
    centre += p.area * p.at;
    normal += p.area * p.tangents.col(0).cross(p.tangents.col(1));
  }
  PlateChart chart;
  chart.origin_ = centre / area;
  // Normals that cancel out leave the direction open.
  chart.normal_ = normal.norm() > 0.0 ? Vector3d(normal.normalized()) : Vector3d::UnitZ();
  if (is_mirrored) {
    chart.origin_.y() = chart.normal_.y() = 0.0;
    chart.normal_.normalize();
  }
  const Vector3d side = is_mirrored ? Vector3d::UnitY() : chart.normal_.unitOrthogonal();
  const auto turn_to = [&](double angle) {
    chart.along_ = Eigen::AngleAxisd(angle, chart.normal_) * side;
    chart.across_ = chart.normal_.cross(chart.along_);
  };
  turn_to(0.0);
  PlateChart found = chart;
  double reached = chart.quality(points);
  const auto try_it = [&](Kind kind, double distance) {
    chart.kind_ = kind;
    chart.distance_ = distance * std::sqrt(area);
    const double quality = chart.quality(points);
    if (quality <= reached) return;
    reached = quality;
    found = chart;
  };
  if (reached < kGood) {
    // A chart that is its own image has its axis along or across the centre plane only.
    const int directions = is_mirrored ? 2 : kDirections;
    for (const double distance : kDistances) {
      for (const double sign : {1.0, -1.0}) {
        try_it(Kind::kCentre, sign * distance);
        for (int i = 0; i < directions; ++i) {
          turn_to(M_PI * i / directions);
          try_it(Kind::kAxis, sign * distance);
        }
        turn_to(0.0);
      }
    }
  }
  if (reached < kBad) return std::nullopt;
  return found;
}

}  // namespace hull::production

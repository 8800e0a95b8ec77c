// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/feature_course.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/arithmetic/gauss.h"
#include "analysis/fairness/plane_fit.h"

namespace hull::analysis {
namespace {

constexpr int kPartsOfSpan = 4;
constexpr int kNodes = 6;
// Of the mean speed: where a curve is slower, its control points all but coincide, and it stands.
constexpr double kStands = 1e-9;

const GaussRule& rule() {
  static const GaussRule gauss = gauss_rule(kNodes);
  return gauss;
}

double gauss_length(const surface::CreaseCurve& curve, double t0, double t1) {
  double sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    sum += rule().weights[i] * curve.evaluate(t0 + (t1 - t0) * rule().nodes[i], 1).d1.norm();
  }
  return (t1 - t0) * sum;
}

}  // namespace

FeatureCourse::FeatureCourse(const surface::CreaseCurve& curve,
                             const std::optional<Vector3d>& seen_along)
    : MeasuredCurve({0.0}, curve.closed()),
      curve_(curve),
      seen_along_(seen_along),
      parameters_({curve.spline().begin()}) {
  const std::vector<double>& knots = curve.spline().knots();
  const double end = curve.spline().end();
  // A cubic B-spline is defined from its fourth knot to its last but three.
  for (std::size_t i = 3; i + 4 < knots.size(); ++i) {
    for (int part = 1; part <= kPartsOfSpan; ++part) {
      const double to = std::min(
          end, knots[i] + (knots[i + 1] - knots[i]) * (static_cast<double>(part) / kPartsOfSpan));
      const double length = gauss_length(curve, parameters_.back(), to);
      // Spans of no length, between points that coincide, would be divided by later.
      if (!(length > 0.0)) continue;
      breaks_.push_back(breaks_.back() + length);
      parameters_.push_back(to);
    }
  }
}

double FeatureCourse::parameter_at(double s) const {
  const auto next = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, s);
  const std::size_t k = next - breaks_.begin() - 1;
  // All of the curve is one point.
  if (k + 1 >= breaks_.size()) return parameters_.front();
  const double t0 = parameters_[k], t1 = parameters_[k + 1];
  const double wanted = s - breaks_[k];
  double t = std::clamp(t0 + (t1 - t0) * wanted / (breaks_[k + 1] - breaks_[k]), t0, t1);
  // Newton on the length: along a quarter of a span the speed hardly changes, and few steps do.
  for (int step = 0; step < 3; ++step) {
    const double speed = curve_.evaluate(t, 1).d1.norm();
    if (!(speed > 0.0)) break;
    t = std::clamp(t + (wanted - gauss_length(curve_, t0, t)) / speed, t0, t1);
  }
  return t;
}

CurveSample FeatureCourse::at(double s) const {
  const surface::CurveJet jet = curve_.evaluate(parameter_at(s), 2);
  CurveSample sample;
  sample.point = jet.point;
  const double speed = jet.d1.norm();
  if (!(speed > 0.0)) return sample;
  sample.tangent = jet.d1 / speed;
  // Its curvature there is a quotient of two numbers that are nothing but rounding, or none.
  const double mean_speed = breaks_.back() / (curve_.spline().end() - curve_.spline().begin());
  if (!(speed > kStands * mean_speed)) return sample;
  if (!seen_along_) {
    const Vector3d across = jet.d2 - sample.tangent.dot(jet.d2) * sample.tangent;
    sample.curvature = across / (speed * speed);
    sample.signed_curvature = sample.curvature.norm();
    return sample;
  }
  const Vector3d& n = *seen_along_;
  const Vector3d d1 = jet.d1 - n.dot(jet.d1) * n;
  const double seen_speed = d1.norm();
  // Where the curve runs along the view its picture is a point.
  if (!(seen_speed > 1e-9 * speed)) return sample;
  sample.signed_curvature = n.dot(d1.cross(jet.d2)) / (seen_speed * seen_speed * seen_speed);
  // Along the picture's own normal, to the left of it.
  sample.curvature = sample.signed_curvature / seen_speed * n.cross(d1);
  return sample;
}

std::optional<Vector3d> normal_of_plane_curve(const surface::CreaseCurve& curve, double tolerance) {
  const std::vector<Vector3d>& points = curve.spline().points();
  const PlaneFit fit = fit_plane(points);
  double off_plane = 0.0, off_line = 0.0;
  for (const Vector3d& p : points) {
    off_plane = std::max(off_plane, std::abs(fit.plane.height(p)));
    // A straight line lies in many planes.
    off_line = std::max(off_line, std::abs(fit.across.dot(p - points.front())));
  }
  if (off_plane > tolerance || off_line <= tolerance) return std::nullopt;
  return fit.plane.normal;
}

}  // namespace hull::analysis

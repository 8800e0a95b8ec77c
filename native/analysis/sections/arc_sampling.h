// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/sections/section_point.h"

namespace hull::analysis {

// A point of an arc and its derivative with respect to the arc's parameter.
struct ArcSample {
  SectionPoint p;
  Vector3d d1;
};

namespace arc_sampling_internal {

inline constexpr int kDeepestChord = 10;  // up to 1025 points an arc

// The cubic with the two points and derivatives as control points between them.
struct HermiteCubic {
  const Vector3d& p0;
  Vector3d p1, p2;
  const Vector3d& p3;
  HermiteCubic(const ArcSample& a, const ArcSample& b, double width)
      : p0(a.p.point),
        p1(a.p.point + width / 3.0 * a.d1),
        p2(b.p.point - width / 3.0 * b.d1),
        p3(b.p.point) {}
  Vector3d middle() const { return 0.125 * (p0 + p3) + 0.375 * (p1 + p2); }
  // Bound on its distance from the chord.
  double off_chord() const {
    const Vector3d chord = p3 - p0;
    const double length2 = chord.squaredNorm();
    const auto off2 = [&](const Vector3d& p) {
      const Vector3d r = p - p0;
      const double along = length2 > 0.0 ? std::clamp(r.dot(chord) / length2, 0.0, 1.0) : 0.0;
      return (r - along * chord).squaredNorm();
    };
    return 0.75 * std::sqrt(std::max(off2(p1), off2(p2)));
  }
};

// Appends the points after `a` up to and including `b`. The arc departs from the Hermite cubic by
// at most `error`, if that is known.
template <class Curve>
void refine(const Curve& curve, double t_a, const ArcSample& a, double t_b, const ArcSample& b,
            double tolerance, double error, int depth, std::vector<SectionPoint>& points) {
  const HermiteCubic cubic(a, b, t_b - t_a);
  const double off = cubic.off_chord();
  if (off + error <= tolerance || depth == kDeepestChord) {
    points.push_back(b.p);
    return;
  }
  const double t_m = 0.5 * (t_a + t_b);
  const ArcSample m = curve.at(t_m);
  const double missed = (cubic.middle() - m.p.point).norm();
  if (off + missed <= tolerance) {
    points.push_back(b.p);
    return;
  }
  // The cubic's error falls with the fourth power of the width; an eighth leaves room.
  refine(curve, t_a, a, t_m, m, tolerance, 0.125 * missed, depth + 1, points);
  refine(curve, t_m, m, t_b, b, tolerance, 0.125 * missed, depth + 1, points);
}

}  // namespace arc_sampling_internal

// Appends points of the arc, from `a` at t_a to `b` at t_b, so that no chord is further than
// `tolerance` from it. curve.at(t) gives samples between.
template <class Curve>
void sample_arc(const Curve& curve, double t_a, const ArcSample& a, double t_b, const ArcSample& b,
                double tolerance, std::vector<SectionPoint>& points) {
  points.push_back(a.p);
  arc_sampling_internal::refine(curve, t_a, a, t_b, b, tolerance,
                                std::numeric_limits<double>::infinity(), 0, points);
}

// Turns what was collected from `first` on round: runs through it the other way.
inline void reverse_points(std::vector<SectionPoint>& points, std::size_t first) {
  std::reverse(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  for (std::size_t i = first; i < points.size(); ++i) {
    points[i].tangent = -points[i].tangent;
    points[i].curvature = -points[i].curvature;
  }
}

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of straight pieces of line, for the tests of sections.
#pragma once

#include <algorithm>
#include <vector>

#include "analysis/sections/section_curves.h"

namespace hull::testing {

// From a point to a straight piece of line.
inline double distance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

inline double length_of(const analysis::SectionCurve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    length += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return length;
}

inline double length_of(const std::vector<analysis::SectionCurve>& curves) {
  double length = 0.0;
  for (const analysis::SectionCurve& curve : curves) length += length_of(curve);
  return length;
}

}  // namespace hull::testing

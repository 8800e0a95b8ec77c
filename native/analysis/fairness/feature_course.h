// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/fairness/measured_curve.h"
#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// A crease or border by its arc length, which is right to about 1e-10.
class FeatureCourse : public MeasuredCurve {
 public:
  // Seen along a unit vector `seen_along` the curve is judged as its picture bends; without it as a
  // space curve. Where its control points all but coincide, so that it stands, it has no curvature.
  // Keeps a reference to the curve.
  FeatureCourse(const surface::CreaseCurve& curve, const std::optional<Vector3d>& seen_along);

  CurveSample at(double s) const override;

 private:
  double parameter_at(double s) const;

  const surface::CreaseCurve& curve_;
  std::optional<Vector3d> seen_along_;
  std::vector<double> parameters_;  // at the breaks
};

// The unit normal of the plane in which the curve lies to `tolerance` (m); none for space curves
// and straight lines. Its largest component is positive.
std::optional<Vector3d> normal_of_plane_curve(const surface::CreaseCurve& curve, double tolerance);

}  // namespace hull::analysis

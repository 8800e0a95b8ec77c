// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/fairness/measured_curve.h"
#include "analysis/sections/sections.h"

namespace hull::analysis {

// A stretch of a section between knuckles, exact between its points too: every point lies on
// surface and plane, and tangent and curvature are those of the two there.
//
// Arc lengths are those of cubics through the points with the exact tangents: their relative errors
// go with the fourth power of the points' distance, and are about 1e-6 for sections sampled to
// 1e-5 of the size.
class SectionCourse : public MeasuredCurve {
 public:
  // Keeps references to the surface and the curve.
  SectionCourse(const surface::LimitSurface& surface, const Plane& plane, const SectionCurve& curve,
                const SmoothStretch& stretch);

  CurveSample at(double s) const override;

 private:
  // Between two points: in one cell, from (u, v) to (u, v); cell -1 if they have none in common.
  struct Segment {
    int cell;
    Eigen::Vector2d from, to;
    bool along_side;  // on a line of constant u or v that lies in the plane
    // d(u, v) at both ends, for a parameter from 0 to 1: the curve's cubic there.
    Eigen::Vector2d leaving, reaching;
  };
  Segment segment_between(int a, int b) const;
  Segment in_common_cell(int a, int b) const;
  double middle_height(const Segment& segment) const;
  void lead(int k);
  Eigen::Vector2d slope_at(const Segment& segment, int k, bool at_end) const;
  CurveSample known(int index) const;
  CurveSample sample(const Vector3d& tangent, const Vector3d& point, double curvature) const;
  bool on_line(const Segment& segment, double fraction, CurveSample& sample) const;
  bool on_plane(const Segment& segment, double fraction, const Vector3d& near,
                const Vector3d& along, CurveSample& sample) const;

  const surface::LimitSurface& surface_;
  Plane plane_;
  const SectionCurve& curve_;
  SmoothStretch stretch_;
  std::vector<Segment> segments_;
};

}  // namespace hull::analysis

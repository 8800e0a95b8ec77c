// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/fairness/course_memory.h"
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
  // Keeps references to the surface and the curve. What the memory, if any, knows of the plane's
  // sections is taken over: the same as it is without.
  SectionCourse(const surface::LimitSurface& surface, const Plane& plane, const SectionCurve& curve,
                const SmoothStretch& stretch, CourseMemory* memory = nullptr);

  CurveSample at(double s) const override;
  double curvature_between(int k, int part, int parts) override;

  // Keeps in the memory, if any, what is known by now.
  void keep() const;

 private:
  // Segments first … last - 1, which are all that are side by side in one cell.
  struct Run {
    int first, last;
  };
  CourseSegment segment_between(int a, int b) const;
  CourseSegment in_common_cell(int a, int b) const;
  double middle_height(const CourseSegment& segment) const;
  void part();
  bool can_be_kept(const Run& run) const;
  std::span<const CoursePoint> points_of(const Run& run) const;
  void lead(int k);
  Eigen::Vector2d slope_at(const CourseSegment& segment, int k, bool at_end) const;
  CurveSample between(int k, double fraction) const;
  CurveSample known(int index) const;
  CurveSample sample(const Vector3d& tangent, const Vector3d& point, double curvature) const;
  bool on_line(const CourseSegment& segment, double fraction, CurveSample& sample) const;
  bool on_plane(const CourseSegment& segment, double fraction, const Vector3d& near,
                const Vector3d& along, CurveSample& sample) const;

  const surface::LimitSurface& surface_;
  Plane plane_;
  const SectionCurve& curve_;
  SmoothStretch stretch_;
  CourseMemory* memory_;
  std::vector<double> lengths_;  // m, between the breaks
  std::vector<CourseSegment> segments_;
  std::vector<Run> runs_;
  std::vector<CoursePoint> points_;  // none without a memory
};

}  // namespace hull::analysis

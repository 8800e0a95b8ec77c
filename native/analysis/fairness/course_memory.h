// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "analysis/fairness/measured_curve.h"
#include "surface/limit_surface.h"

namespace hull::analysis {

// A point of a section, with all that the course of the section beside it depends on.
struct CoursePoint {
  int cell;
  Eigen::Vector2d uv;
  Vector3d point, tangent;
  double curvature;  // 1/m
  bool operator==(const CoursePoint& other) const;
};

// A section between two of its points: in one cell, from (u, v) to (u, v); cell -1 if they have
// none in common.
struct CourseSegment {
  int cell;
  Eigen::Vector2d from, to;
  bool along_side;   // on a line of constant u or v that lies in the plane
  bool is_compared;  // the places of other cells decided on this one
  // d(u, v) at both ends, for a parameter from 0 to 1: the curve's cubic there.
  Eigen::Vector2d leaving, reaching;
  int parts = 0;  // that part_curvatures, 1/m, were taken between; 0: none were
  std::array<double, kMostProbedParts - 1> part_curvatures{};
};

// What was found out about the courses of the sections by one plane, to be taken over where the
// surface has not moved since.
class CourseMemory {
 public:
  // Before the sections of a surface as it is are followed, all of them: what is known is of those
  // of the last time.
  void begin(const surface::LimitSurface& surface);

  // Segments that are all there are side by side in one cell, between these points: whether they
  // are known, and then as they are known.
  bool recall(std::span<const CoursePoint> points, std::span<CourseSegment> segments);

  // REQUIRES: as recall(); none of them is of no cell, or compared.
  void keep(std::span<const CoursePoint> points, std::span<const CourseSegment> segments);

  // How many segments were taken over since begin().
  int recalled_count() const { return recalled_; }

 private:
  // Of the points and segments of one cell the first ones' numbers; count: of the segments.
  struct Run {
    int cell, first_point, first_segment, count;
  };
  struct Known {
    std::vector<Run> runs;
    std::vector<CoursePoint> points;
    std::vector<CourseSegment> segments;
  };
  bool is_of(const Run& run, std::span<const CoursePoint> points) const;

  Known before_, now_;
  const surface::LimitSurface* surface_ = nullptr;
  int revision_before_ = -1, revision_ = -1;  // of the surface, at begin()
  double size_ = 0.0;                         // of its mesh
  std::size_t next_ = 0;                      // run of before_: they come in the same order
  int recalled_ = 0;
};

}  // namespace hull::analysis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/course_memory.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hull::analysis {

bool CoursePoint::operator==(const CoursePoint& other) const {
  return cell == other.cell && curvature == other.curvature && uv == other.uv &&
         point == other.point && tangent == other.tangent;
}

void CourseMemory::begin(const surface::LimitSurface& surface) {
  std::swap(before_, now_);
  now_.runs.clear();
  now_.points.clear();
  now_.segments.clear();
  // What counts as rounding is a part of the size.
  if (surface_ != &surface || size_ != surface.mesh().size()) before_.runs.clear();
  surface_ = &surface;
  size_ = surface.mesh().size();
  revision_before_ = std::exchange(revision_, surface.revision());
  next_ = 0;
  recalled_ = 0;
}

bool CourseMemory::is_of(const Run& run, std::span<const CoursePoint> points) const {
  const auto first = before_.points.begin() + run.first_point;
  return run.count + 1 == static_cast<int>(points.size()) &&
         std::equal(points.begin(), points.end(), first);
}

bool CourseMemory::recall(std::span<const CoursePoint> points, std::span<CourseSegment> segments) {
  assert(points.size() == segments.size() + 1);
  const int cell = segments.front().cell;
  if (surface_->moved_at(cell) > revision_before_) return false;
  for (std::size_t i = 0; i < before_.runs.size(); ++i) {
    const std::size_t at = (next_ + i) % before_.runs.size();
    const Run& run = before_.runs[at];
    if (run.cell != cell || !is_of(run, points)) continue;
    std::copy_n(before_.segments.begin() + run.first_segment, run.count, segments.begin());
    next_ = at + 1;
    recalled_ += run.count;
    return true;
  }
  return false;
}

void CourseMemory::keep(std::span<const CoursePoint> points,
                        std::span<const CourseSegment> segments) {
  now_.runs.push_back({segments.front().cell, static_cast<int>(now_.points.size()),
                       static_cast<int>(now_.segments.size()), static_cast<int>(segments.size())});
  now_.points.insert(now_.points.end(), points.begin(), points.end());
  now_.segments.insert(now_.segments.end(), segments.begin(), segments.end());
}

}  // namespace hull::analysis

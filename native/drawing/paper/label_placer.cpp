// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/label_placer.h"

#include <algorithm>

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

// Long curves in runs of so many segments: of most runs the box alone tells that they are not near.
constexpr std::size_t kRunLength = 16;

// Whether the circles around both boxes do: quickly told of most.
bool may_overlap(const OrientedBox& a, const OrientedBox& b) {
  return (b.centre - a.centre).norm() < a.half.norm() + b.half.norm();
}

AlignedBox2d bounds_of(const OrientedBox& box) {
  AlignedBox2d bounds;
  for (const Vector2d& corner : box.corners()) bounds.extend(corner);
  return bounds;
}

}  // namespace

int LabelPlacer::add_curve(const std::vector<Vector2d>& points) {
  Curve curve;
  for (std::size_t i = 0; i < points.size(); ++i) {
    curve.bounds.extend(points[i]);
    if (i == 0) continue;
    // Neighbouring runs share a point, so that no segment is lost between them.
    if ((i - 1) % kRunLength == 0) curve.runs.emplace_back();
    Run& run = curve.runs.back();
    run.bounds.extend(points[i - 1]);
    run.bounds.extend(points[i]);
    run.segments.push_back({points[i - 1], points[i]});
  }
  curves_.push_back(std::move(curve));
  return static_cast<int>(curves_.size()) - 1;
}

bool LabelPlacer::is_free(const OrientedBox& box, int own_curve) const {
  // Boxes come first: each is one comparison, a curve many.
  for (const OrientedBox& other : boxes_) {
    if (may_overlap(box, other) && overlap(box, other)) return false;
  }
  // Upright boxes are told apart at once, also where the label is turned.
  const AlignedBox2d bounds = bounds_of(box);
  for (int i = 0; i < static_cast<int>(curves_.size()); ++i) {
    if (i == own_curve || !curves_[i].bounds.intersects(bounds)) continue;
    for (const Run& run : curves_[i].runs) {
      if (!run.bounds.intersects(bounds)) continue;
      for (const Segment& segment : run.segments) {
        if (overlap(box, segment.a, segment.b)) return false;
      }
    }
  }
  return true;
}

bool LabelPlacer::is_free(const Vector2d& a, const Vector2d& b) const {
  return std::none_of(boxes_.begin(), boxes_.end(),
                      [&](const OrientedBox& box) { return overlap(box, a, b); });
}

}  // namespace hull::drawing

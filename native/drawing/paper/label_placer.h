// SPDX-License-Identifier: GPL-3.0-or-later
// Where on the page a label may still go: clear of the curves and of the labels placed before.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "drawing/paper/oriented_box.h"

namespace hull::drawing {

class LabelPlacer {
 public:
  static constexpr int kNoCurve = -1;

  // A curve labels keep clear of. Returns its number.
  int add_curve(const std::vector<Eigen::Vector2d>& points);

  // A box labels keep clear of.
  void add_box(const OrientedBox& box) { boxes_.push_back(box); }

  // Whether `box` overlaps no box and no curve but the one numbered `own_curve`.
  bool is_free(const OrientedBox& box, int own_curve = kNoCurve) const;

  // Whether the segment from a to b passes through no box.
  bool is_free(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

 private:
  struct Segment {
    Eigen::Vector2d a, b;
  };
  // Some segments one after the other.
  struct Run {
    Eigen::AlignedBox2d bounds;
    std::vector<Segment> segments;
  };
  struct Curve {
    Eigen::AlignedBox2d bounds;
    std::vector<Run> runs;
  };

  std::vector<Curve> curves_;
  std::vector<OrientedBox> boxes_;
};

}  // namespace hull::drawing

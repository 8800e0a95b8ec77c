// SPDX-License-Identifier: GPL-3.0-or-later
// The sheet of a lines plan: where its views lie.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "drawing/paper/sheet.h"

namespace hull::drawing {

// Where one view of the hull lies.
struct View {
  Eigen::AlignedBox2d bounds;  // everything that belongs to the view is inside
  Eigen::Vector2d origin;      // page point of the view's ship coordinates (0, 0)
  double scale;                // millimetres of page per metre of ship

  Eigen::Vector2d to_page(double right, double up) const {
    return {origin.x() + scale * right, origin.y() - scale * up};
  }
};

// Which views a plan has; one at least.
struct PlanViews {
  bool profile = true, half_breadth = true, body_plan = true;
};

struct LinesSheet : Sheet {
  double scale_denominator;  // 200 for 1:200
  Eigen::AlignedBox2d frame;
  Eigen::AlignedBox2d title_block;
  Eigen::AlignedBox2d table;  // of offsets; empty without one
  int table_form = 0;         // which of the table's forms (offsets_block.h) has found its place
  View profile, half_breadth, body_plan;
};

}  // namespace hull::drawing

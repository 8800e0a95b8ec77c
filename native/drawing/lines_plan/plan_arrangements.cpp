// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/plan_arrangements.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kGap = 4.0;  // least distance of two blocks

// Where blocks of these lengths begin, one after the other from `low` to `high`, with the room left
// shared evenly among the gaps between and at both ends.
std::vector<double> spread(double low, double high, const std::vector<double>& lengths) {
  const double taken = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  // Negative where there is too little room: then the blocks overlap, and fits() refuses.
  const double gap = (high - low - taken) / static_cast<double>(lengths.size() + 1);
  std::vector<double> starts;
  double at = low + gap;
  for (const double length : lengths) {
    starts.push_back(at);
    at += length + gap;
  }
  return starts;
}

double centred(double low, double high, double length) { return 0.5 * (low + high - length); }

bool fits(const PlanBlocks& blocks, const PlanCorners& corners, const AlignedBox2d& area,
          const AlignedBox2d& title_block) {
  constexpr double kRounding = 1e-9;
  std::vector<AlignedBox2d> boxes;
  const auto add = [&boxes](const Vector2d& corner, const Vector2d& size) {
    boxes.emplace_back(corner, corner + size);
  };
  add(corners.profile, blocks.profile);
  add(corners.half_breadth, blocks.half_breadth);
  add(corners.body_plan, blocks.body_plan);
  if (blocks.table) add(corners.table, *blocks.table);
  const Vector2d slack = Vector2d::Constant(kRounding);
  const AlignedBox2d inside(area.min() - slack, area.max() + slack);
  for (const AlignedBox2d& box : boxes) {
    if (!inside.contains(box)) return false;
  }
  // Only now: it touches the frame, so it is not within the area.
  boxes.push_back(title_block);
  // Grown by half the gap each, boxes are apart by the gap where they do not meet. Touching ones
  // would intersect, so a rounding less.
  const Vector2d half_gap = Vector2d::Constant(0.5 * kGap - kRounding);
  for (AlignedBox2d& box : boxes) box = AlignedBox2d(box.min() - half_gap, box.max() + half_gap);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes[i].intersects(boxes[j])) return false;
    }
  }
  return true;
}

// The body plan beside the profile, above the title block; the table between the two, or below the
// half-breadth plan.
PlanCorners side_by_side(const PlanBlocks& blocks, const AlignedBox2d& area,
                         const AlignedBox2d& title, bool table_to_the_right) {
  const bool right_table = blocks.table && table_to_the_right;
  const bool left_table = blocks.table && !table_to_the_right;
  // The title block is in the right column too.
  double right_width = std::max(blocks.body_plan.x(), area.max().x() - title.min().x());
  double left_width = blocks.profile.x();
  if (right_table) right_width = std::max(right_width, blocks.table->x());
  if (left_table) left_width = std::max(left_width, blocks.table->x());
  const std::vector<double> columns =
      spread(area.min().x(), area.max().x(), {left_width, right_width});

  // Profile and body plan begin in one row, so that they share the base line.
  std::vector<double> heights = {blocks.profile.y(), blocks.half_breadth.y()};
  if (left_table) heights.push_back(blocks.table->y());
  const std::vector<double> rows = spread(area.min().y(), area.max().y(), heights);
  const double left = columns[0] + 0.5 * (left_width - blocks.profile.x());
  PlanCorners corners{{left, rows[0]},
                      {left, rows[1]},
                      {columns[1] + 0.5 * (right_width - blocks.body_plan.x()), rows[0]},
                      Vector2d::Zero()};
  if (left_table) {
    corners.table = {columns[0] + 0.5 * (left_width - blocks.table->x()), rows[2]};
  }
  if (right_table) {
    // Between the body plan and the title block.
    const double low = rows[0] + blocks.body_plan.y();
    corners.table = {columns[1] + 0.5 * (right_width - blocks.table->x()),
                     centred(low, title.min().y(), blocks.table->y())};
  }
  return corners;
}

// Profile, half-breadth plan and body plan from top to bottom; the table to the right of the body
// plan, beside the title block or above it.
PlanCorners stacked(const PlanBlocks& blocks, const AlignedBox2d& area, const AlignedBox2d& title,
                    bool table_above_title) {
  const std::vector<double> rows =
      spread(area.min().y(), area.max().y(),
             {blocks.profile.y(), blocks.half_breadth.y(), blocks.body_plan.y()});
  const double left = centred(area.min().x(), area.max().x(), blocks.profile.x());
  PlanCorners corners{{left, rows[0]}, {left, rows[1]}, Vector2d::Zero(), Vector2d::Zero()};
  // The body plan is below this, and beside it the table.
  const double views_end = rows[1] + blocks.half_breadth.y();
  if (!blocks.table || table_above_title) {
    double right_start = title.min().x();
    if (blocks.table) {
      right_start = std::min(right_start, area.max().x() - blocks.table->x());
      corners.table = {centred(right_start, area.max().x(), blocks.table->x()),
                       centred(views_end, title.min().y(), blocks.table->y())};
    }
    corners.body_plan = {centred(area.min().x(), right_start, blocks.body_plan.x()), rows[2]};
    return corners;
  }
  const std::vector<double> columns =
      spread(area.min().x(), title.min().x(), {blocks.body_plan.x(), blocks.table->x()});
  corners.body_plan = {columns[0], rows[2]};
  corners.table = {columns[1], centred(views_end, area.max().y(), blocks.table->y())};
  return corners;
}

}  // namespace

std::optional<PlanCorners> arrange_plan(const PlanBlocks& blocks, const AlignedBox2d& area,
                                        const AlignedBox2d& title) {
  // The order is that of preference: the first that fits is taken.
  const std::vector<PlanCorners> proposals = {
      side_by_side(blocks, area, title, true), side_by_side(blocks, area, title, false),
      stacked(blocks, area, title, false), stacked(blocks, area, title, true)};
  for (const PlanCorners& corners : proposals) {
    if (fits(blocks, corners, area, title)) return corners;
  }
  return std::nullopt;
}

}  // namespace hull::drawing

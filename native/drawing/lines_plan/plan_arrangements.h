// SPDX-License-Identifier: GPL-3.0-or-later
// How the views, the table and the title block of a lines plan may be arranged on the paper.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace hull::drawing {

// Sizes in mm. Profile and body plan keep the same room above and below the hull, so that with
// their upper ends in line they share the base line.
struct PlanBlocks {
  Eigen::Vector2d profile, half_breadth, body_plan;
  std::optional<Eigen::Vector2d> table;
};

// The upper left corners.
struct PlanCorners {
  Eigen::Vector2d profile, half_breadth, body_plan;
  Eigen::Vector2d table;  // without meaning if there is none
};

// The first arrangement in which all blocks are inside `area`, and apart from one another and from
// the title block in its lower right corner; none if there is none. The half-breadth plan is
// always below the profile, left ends in line. The body plan is beside the profile, or below
// both. The table is beneath the views, or beside or above the title block. What room is left is
// shared out evenly.
std::optional<PlanCorners> arrange_plan(const PlanBlocks& blocks, const Eigen::AlignedBox2d& area,
                                        const Eigen::AlignedBox2d& title_block);

}  // namespace hull::drawing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "morphing/overlay/edge_traces.h"

namespace hull::morphing {

// The points of two merged discs, by number: those of the first, others of the second, crossings.
struct MergedPoints {
  std::array<std::vector<int>, 2> numbers;  // of the points of each disc
  // Of each crossing, in the order of its edges' numbers.
  std::vector<std::array<int, 2>> crossings;
  int first_crossing = 0;
  int shared_count = 0;

  int count() const { return first_crossing + static_cast<int>(crossings.size()); }
  // REQUIRES: these edges cross.
  int number_of(const std::array<int, 2>& edges) const;
};

// Throws std::invalid_argument for more than 5e7 crossings.
MergedPoints merged_points(const std::array<const DiscMap*, 2>& maps,
                           const std::array<EdgeTraces, 2>& traces);

// Where the points are in the plane, and on each disc.
struct MergedPositions {
  std::vector<Vector2d> places;
  std::array<std::vector<Vector3d>, 2> points;  // m
};

MergedPositions merged_positions(const std::array<const DiscMap*, 2>& maps,
                                 const CommonBorder& border,
                                 const std::array<EdgeTraces, 2>& traces,
                                 const MergedPoints& merged);

}  // namespace hull::morphing

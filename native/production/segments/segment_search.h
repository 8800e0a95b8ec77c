// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "production/segments/segment_grid.h"

namespace hull::production {

// The best way to cut each box of a grid in two, and the parts again, found once for each box from
// the smallest to the largest.
class SegmentSearch {
 public:
  // REQUIRES: the grid has at most kMostBoxes boxes.
  SegmentSearch(const SegmentGrid& grid, const surface::Progress& progress);

  // Where a box is cut: axis and plane; axis -1 where it is left whole.
  struct Cut {
    signed char axis = -1;
    short plane = 0;
  };
  Cut best_cut(const SegmentBox& box) const { return found_[number(box)].cut; }
  SegmentBox whole() const;
  bool is_empty(const SegmentBox& box) const { return found_[number(box)].count == 0; }

 private:
  struct Best {
    double penalty = 0.0, roots = 0.0;
    int count = 0;
    Cut cut;
  };

  std::size_t number(const SegmentBox& box) const;
  Best searched(const SegmentBox& box) const;
  bool is_better(const Best& a, const Best& b) const;

  const SegmentGrid& grid_;
  std::array<int, 3> layers_;
  std::vector<Best> found_;
};

}  // namespace hull::production
